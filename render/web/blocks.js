// The arrays of the page, unpacked when they are asked for.
export class Blocks {
  constructor() {
    /** @type {NodeListOf<HTMLScriptElement>} */
    this.elements = document.querySelectorAll('script.block');
    /** @type {Map<number, Promise<any>>} */
    this.unpacked = new Map();
  }

  // A promise of the typed array; every caller gets the same promise.
  /**
   * @template T
   * @param {Block<T>} number
   * @returns {Promise<T>}
   */
  get(number) {
    const known = this.unpacked.get(number) ?? this.unpack(this.elements[number]);
    this.unpacked.set(number, known);
    return known;
  }

  // What will not be asked for again.
  /** @param {number | undefined} number */
  forget(number) {
    if (number !== undefined) this.unpacked.delete(number);
  }

  /** @param {HTMLScriptElement} element */
  async unpack(element) {
    const text = atob(element.text);
    const packed = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    const planes = new Uint8Array(await new Response(stream).arrayBuffer());
    const kinds = { u8: Uint8Array, u32: Uint32Array, f32: Float32Array, f64: Float64Array };
    const kind = kinds[/** @type {keyof typeof kinds} */ (element.dataset.type)], count = Number(element.dataset.count);
    const size = kind.BYTES_PER_ELEMENT, bytes = new Uint8Array(planes.length);
    for (let plane = 0; plane < size; ++plane)
      for (let i = 0, from = plane * count; i < count; ++i) bytes[i * size + plane] = planes[from + i];
    return new kind(bytes.buffer);
  }
}
