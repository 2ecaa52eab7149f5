export const shapeNames = ['none', 'scb', 'scb2', 'box', 'polytope', 'rounded'];
const numbersOf = [0, 9, 14, 12, 4, 5];  // of WebShape, see tree_blocks.h
const texelWidth = 2048;

// A hierarchy. Its nodes are in the order of their levels; levels are unpacked when they are shown, small ones together. "Slot" is a node's place in this
// order, "node" its index, by which pixels and queries name it, "number" what users call it: of another engine's tree, its own number.
export class Tree {
  // From open(): per slot.
  order = new Uint32Array();
  children = new Uint32Array();
  firstChild = new Uint32Array();
  parent = new Int32Array();
  numbers = new Uint32Array();
  /** @type {Record<number, string>} */
  names = {};
  // By node and by number, filled when they are asked for.
  /** @type {Map<number, number>} */
  slots = new Map();
  // From upload().
  /** @type {WebGLTexture | null} */
  volumeTexture = null;
  /** @type {WebGLTexture | null} */
  extraTexture = null;
  /** @type {Map<number, number> | undefined} */
  numbered;
  // From openItems().
  items = new Uint32Array();
  firstItem = new Uint32Array();

  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Blocks} blocks
   * @param {ManifestTree} stored
   */
  constructor(gl, blocks, stored) {
    this.gl = gl;
    this.blocks = blocks;
    this.stored = stored;
    this.start = [0];
    for (const count of stored.counts) this.start.push(this.start[this.start.length - 1] + count);
    this.depth = stored.counts.length - 1;
    /** @type {TreePart[]} */
    this.parts = [];  // those that are unpacked: the first ones
    this.loading = Promise.resolve();
  }

  // Unpacks the order, children, parents, numbers and names of the nodes. All other methods need them.
  async open() {
    this.order = await this.blocks.get(this.stored.order);
    this.children = await this.blocks.get(this.stored.children);
    const count = this.order.length;
    this.firstChild = new Uint32Array(count);
    this.parent = new Int32Array(count).fill(-1);
    let next = this.stored.counts[0] ?? 0;
    for (let slot = 0; slot < count; ++slot) {
      this.firstChild[slot] = next;
      for (let i = 0; i < this.children[slot]; ++i) this.parent[next++] = slot;
    }
    this.numbers = this.stored.numbers !== undefined ? await this.blocks.get(this.stored.numbers) : this.order;
    this.names = this.stored.names !== undefined ? JSON.parse(new TextDecoder().decode(await this.blocks.get(this.stored.names))) : {};
  }

  // Which triangles, or objects, a node has itself.
  async openItems() {
    if (this.firstItem.length > 0) return;
    const counts = await this.blocks.get(this.stored.item_counts);
    this.items = await this.blocks.get(this.stored.items);
    const first = new Uint32Array(counts.length + 1);
    counts.forEach((count, slot) => (first[slot + 1] = first[slot] + count));
    this.firstItem = first;
  }

  /** @param {number} slot */
  itemsOf(slot) {
    return this.items.subarray(this.firstItem[slot], this.firstItem[slot + 1]);
  }

  /** @param {number} node */
  slotOf(node) {
    if (this.slots.size === 0) this.order.forEach((of, slot) => this.slots.set(of, slot));
    return this.slots.get(node) ?? -1;
  }
  /** @param {number} number */
  slotOfNumber(number) {
    if (this.numbers === this.order) return this.slotOf(number);
    this.numbered ??= new Map(Array.from(this.numbers, (of, slot) => [of, slot]));
    return this.numbered.get(number) ?? -1;
  }
  /** @param {number} slot */
  numberOf(slot) {
    return this.numbers[slot];
  }
  // The number, and the name in quotes where it has one.
  /** @param {number} slot */
  wordsOf(slot) {
    const name = this.names[this.order[slot]];
    return name === undefined ? String(this.numbers[slot]) : `${this.numbers[slot]} "${name}"`;
  }

  /** @param {number} slot */
  levelOf(slot) {
    let least = 0, most = this.depth;
    while (least < most) {
      const middle = (least + most + 1) >> 1;
      if (this.start[middle] <= slot) least = middle;
      else most = middle - 1;
    }
    return least;
  }

  // Whether the volumes of a level are unpacked.
  /** @param {number} level */
  has(level) {
    const last = this.parts.at(-1);
    return last !== undefined && Math.min(level, this.depth) < last.end;
  }

  // Unpacks all levels down to this one, part after part.
  /** @param {number} level */
  load(level) {
    // One after the other; what failed does not stop the next.
    this.loading = this.loading.catch(() => {}).then(async () => {
      if (this.has(level) || this.depth < 0) return;
      while (!this.has(level)) this.parts.push(await this.unpack(this.stored.parts[this.parts.length]));
      this.upload();
    });
    return this.loading;
  }

  /**
   * @param {ManifestPart} stored
   * @returns {Promise<TreePart>}
   */
  async unpack(stored) {
    const shapes = await this.blocks.get(stored.shapes), numbers = await this.blocks.get(stored.numbers);
    const colors = await this.blocks.get(stored.colors), count = shapes.length;
    const extras = stored.extras !== undefined ? await this.blocks.get(stored.extras) : null;
    const extraTexels = stored.texels !== undefined ? await this.blocks.get(stored.texels) : new Float32Array(0);
    for (const block of [stored.shapes, stored.numbers, stored.colors, stored.extras, stored.texels]) this.blocks.forget(block);
    const first = this.parts.at(-1)?.last ?? 0, before = this.parts.at(-1)?.extrasEnd ?? 0;
    const texels = new Float32Array(16 * count), offsets = new Uint32Array(count);
    let extra = before;
    for (let i = 0, at = 0; i < count; ++i) {
      const shape = shapes[i], n = numbersOf[shape];
      offsets[i] = at;
      texels.set(numbers.subarray(at, at + n), 16 * i);
      at += n;
      const packed = extras ? extras[i] : 0, many = packed & 0x7fffffff;
      if (many > 0) texels.set([extra, many, packed >>> 31], 16 * i + 12);
      extra += many;
    }
    const end = (this.parts.at(-1)?.end ?? 0) + stored.levels;  // the first level behind it
    return { shapes, numbers, offsets, colors, texels, extraTexels, first, last: first + count, extrasEnd: extra, end };
  }

  /** @type {(unit: number, arrays: Float32Array[]) => WebGLTexture | null} */
  texture(unit, arrays) {
    const { gl } = this, floats = arrays.reduce((sum, array) => sum + array.length, 0);
    const rows = Math.max(1, Math.ceil(floats / 4 / texelWidth));
    if (rows > gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error('This level has more volumes than the graphics system can hold.');
    const all = new Float32Array(4 * texelWidth * rows);
    let at = 0;
    for (const array of arrays) {
      all.set(array, at);
      at += array.length;
    }
    const texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, texelWidth, rows);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, texelWidth, rows, gl.RGBA, gl.FLOAT, all);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  upload() {
    const { gl } = this;
    for (const old of [this.volumeTexture, this.extraTexture]) if (old) gl.deleteTexture(old);
    this.volumeTexture = this.texture(0, this.parts.map((part) => part.texels));
    this.extraTexture = this.texture(1, this.parts.map((part) => part.extraTexels));
  }

  // The slots that cover the body at a level: its nodes, and the leaves above; or of them those below a node.
  /** @param {number} level */
  cover(level, root = -1) {
    const slots = [], last = Math.min(level, this.depth);
    for (let depth = 0; depth <= last; ++depth)
      for (let slot = this.start[depth]; slot < this.start[depth + 1]; ++slot)
        if (depth === last || this.children[slot] === 0) if (root < 0 || this.isBelow(slot, root)) slots.push(slot);
    return slots;
  }

  /** @type {(slot: number, root: number) => boolean} */
  isBelow(slot, root) {
    while (slot > root) slot = this.parent[slot];
    return slot === root;
  }

  /** @param {number} slot */
  partOf(slot) {
    const part = this.lastPart ?? this.parts[0];
    return slot >= part.first && slot < part.last ? part : (this.lastPart = this.parts[this.parts.findIndex(({ last }) => slot < last)]);
  }

  // Its planes or points, four numbers each.
  /** @param {number} slot */
  extrasOf(slot) {
    const { first, texels, extrasEnd, extraTexels } = this.partOf(slot), at = 16 * (slot - first) + 12;
    const begin = 4 * (texels[at] - extrasEnd) + extraTexels.length;
    return extraTexels.subarray(begin, begin + 4 * texels[at + 1]);
  }

  // Shape, numbers and color of a slot whose level is unpacked.
  /**
   * @param {number} slot
   * @returns {Volume}
   */
  volume(slot) {
    const part = this.partOf(slot);
    const i = slot - part.first, shape = part.shapes[i], at = part.offsets[i];
    return {
      shape,
      numbers: part.numbers.subarray(at, at + numbersOf[shape]),
      color: part.colors.subarray(3 * i, 3 * i + 3),
      extras: part.texels[16 * i + 13],
    };
  }
}

// Of a ball about a volume.
/** @param {Volume} volume */
export function radiusOf({ shape, numbers }) {
  return shapeNames[shape] === 'box' ? Math.hypot(numbers[3], numbers[7], numbers[11]) : numbers[3] ?? 0;
}
