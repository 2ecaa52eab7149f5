// The arrays of the page, unpacked when they are asked for.
export class Blocks {
  constructor() {
    this.elements = document.querySelectorAll('script.block');
    this.unpacked = new Map();
  }

  // A promise of the typed array; one for all who ask.
  get(number) {
    if (!this.unpacked.has(number)) this.unpacked.set(number, this.unpack(this.elements[number]));
    return this.unpacked.get(number);
  }

  // What will not be asked for again.
  forget(number) {
    this.unpacked.delete(number);
  }

  async unpack(element) {
    const text = atob(element.textContent);
    const packed = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    const planes = new Uint8Array(await new Response(stream).arrayBuffer());
    const { type, count } = element.dataset;
    const kind = { u8: Uint8Array, u32: Uint32Array, f32: Float32Array, f64: Float64Array }[type];
    const size = kind.BYTES_PER_ELEMENT, bytes = new Uint8Array(planes.length);
    for (let plane = 0; plane < size; ++plane)
      for (let i = 0, from = plane * count; i < count; ++i) bytes[i * size + plane] = planes[from + i];
    return new kind(bytes.buffer);
  }
}
