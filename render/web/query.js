import { radiusOf } from './tree.js';

// Verdicts on a test, `right` and then in the order of the page's `worths`.
export const worth = { right: 0, loose: 1, weak: 2, wrong: 3 };

// The tests of a query in one frame. Arrays have an entry for each test; nodes are slots of their trees; -1: one that no root leads to, in recordings
// of broken trees.
export class QueryFrame {
  // Kept once they are asked for.
  /** @type {Classes | null} */
  #judged = null;
  /** @type {Followers | null} */
  #followers = null;
  /** @type {Cells | null} */
  #cells = null;
  /** @type {Set<number> | null} */
  #known = null;
  /** @type {Map<number, number> | null} */
  places = null;
  /** @type {Record<number, Explanation> | null} */
  explained = null;
  /** @type {number | null} */
  onlyHere = null;
  /** @type {{ than: QueryFrame, pairs: number[][] } | null} */
  onlyPairs = null;

  /**
   * @param {Query} query
   * @param {ManifestFrame} stored
   * @param {Uint8Array} bits see render/web/query_blocks.h, as `nodes`
   * @param {Uint32Array} pairs
   * @param {Uint32Array | null} nodes
   * @param {Float32Array | null} bounds
   * @param {Float64Array | null} lines
   */
  constructor(query, stored, bits, pairs, nodes, bounds, lines) {
    const { trees } = query, count = bits.length, outcomes = bits.map((byte) => byte & 63);
    const a = new Int32Array(count), b = new Int32Array(count), parents = new Int32Array(count).fill(-1);
    if (nodes) {
      for (let i = 0; i < count; ++i) {
        a[i] = trees[0].slotOf(nodes[3 * i]);
        b[i] = trees[1].slotOf(nodes[3 * i + 1]);
        parents[i] = nodes[3 * i + 2] | 0;  // none is -1
      }
    } else {
      // Predicted: first the roots, then all children of the pair that was divided last.
      /** @type {number[]} */
      const divided = [];
      let next = 0;
      const visit = (/** @type {number} */ slot_a, /** @type {number} */ slot_b, /** @type {number} */ parent) => {
        parents[next] = parent;
        a[next] = slot_a;
        b[next] = slot_b;
        if (outcomes[next] < 2) divided.push(next);
        ++next;
      };
      if (count > 0) visit(0, 0, -1);
      for (let test = divided.pop(); test !== undefined; test = divided.pop()) {
        const of_a = outcomes[test] === 0, slot = of_a ? a[test] : b[test], tree = trees[of_a ? 0 : 1];
        const first = tree.firstChild[slot], end = first + tree.children[slot];
        for (let child = first; child < end; ++child) of_a ? visit(child, b[test], test) : visit(a[test], child, test);
      }
    }
    const meets = new Uint8Array(count), worths = new Uint8Array(count);
    for (let i = count - 1; i >= 0; --i) {
      if (bits[i] & 128) meets[i] = 1;
      if (meets[i] && parents[i] >= 0) meets[parents[i]] = 1;
      const erred = (bits[i] & 64) !== 0;
      if (stored.judged) worths[i] = query.rejects(outcomes[i]) ? (erred ? worth.wrong : worth.right) : meets[i] ? worth.right : erred ? worth.weak : worth.loose;
    }
    this.query = query;
    this.stored = stored;
    this.outcomes = outcomes;
    this.a = a;
    this.b = b;
    this.parents = parents;
    this.pairs = pairs;
    this.bounds = bounds;
    this.lines = lines;
    this.meets = meets;
    this.worths = worths;
    this.passed = outcomes.reduce((sum, outcome) => sum + (outcome < 2 ? 1 : 0), 0);  // tests that others followed from
    this.ended = query.classes(this, outcomes.map((outcome) => Math.max(outcome - 1, 0)), query.stored.groups.length);
  }

  /** @type {(x: number, y: number) => boolean} */
  hasPair(x, y) {
    const { pairs } = this;
    if (!this.#known) {
      this.#known = new Set();
      for (let i = 0; i < pairs.length; i += 2) this.#known.add(pairs[i] * 2 ** 32 + pairs[i + 1]);
    }
    return this.#known.has(x * 2 ** 32 + y);
  }

  // The tests by verdict.
  get judged() {
    return (this.#judged ??= this.query.classes(this, this.worths, this.query.stored.worths.length));
  }

  get followers() {
    return (this.#followers ??= followersOf(this));
  }

  get cells() {
    return (this.#cells ??= cellsOf(this));
  }
}

/** @type {(frame: QueryFrame) => Followers} */
function followersOf({ outcomes, parents, ended }) {
  const count = outcomes.length, groups = ended.counts.length, below = new Uint32Array(count * groups);
  const sizes = new Uint32Array(count).fill(1), dominant = new Int32Array(count).fill(-1), first = new Int32Array(count).fill(-1), next = new Int32Array(count).fill(-1);
  for (let i = count - 1; i >= 0; --i) {
    const parent = parents[i];
    if (outcomes[i] >= 2) ++below[i * groups + outcomes[i] - 2];
    for (let g = 0, most = 0; g < groups; ++g) {
      const n = below[i * groups + g];
      if (n > most) [most, dominant[i]] = [n, g];
      if (parent >= 0) below[parent * groups + g] += n;
    }
    if (parent < 0) continue;
    sizes[parent] += sizes[i];
    next[i] = first[parent];
    first[parent] = i;
  }
  return { sizes, dominant, first, next };
}

/** @type {(frame: QueryFrame) => Cells} */
function cellsOf({ query, a, b, outcomes }) {
  /** @type {Map<string, Cell>} */
  const all = new Map();
  let wide = 0, high = 0;
  a.forEach((slot, i) => {
    if (slot < 0 || b[i] < 0) return;
    const x = query.trees[0].levelOf(slot), y = query.trees[1].levelOf(b[i]), key = `${x},${y}`, cell = all.get(key) ?? { x, y, tests: 0, rejected: 0 };
    ++cell.tests;
    cell.rejected += query.rejects(outcomes[i]) ? 1 : 0;
    all.set(key, cell);
    wide = Math.max(wide, x + 1);
    high = Math.max(high, y + 1);
  });
  return { all, wide, high, most: Math.max(1, ...[...all.values()].map(({ tests }) => tests)) };
}

// A query by one kind of volumes, frame by frame.
export class Query {
  /**
   * @param {Blocks} blocks
   * @param {ManifestQuery} stored
   * @param {Tree[]} trees
   */
  constructor(blocks, stored, trees) {
    this.blocks = blocks;
    this.stored = stored;
    this.trees = trees;
    this.frames = new Map(stored.frames.map((frame) => [frame.frame, frame]));
    /** @type {Map<number, Promise<QueryFrame>>} */
    this.unpacked = new Map();
  }

  // A promise of a frame's data; null where the page does not have its query.
  /**
   * @param {number} number
   * @returns {Promise<QueryFrame | null>}
   */
  get(number) {
    const stored = this.frames.get(number);
    if (!stored) return Promise.resolve(null);
    const known = this.unpacked.get(number);
    if (known) return known;
    this.unpacked.clear();  // one frame at a time
    const unpacked = this.unpack(stored);
    this.unpacked.set(number, unpacked);
    return unpacked;
  }

  /** @param {ManifestFrame} stored */
  async unpack(stored) {
    const bits = await this.blocks.get(stored.outcomes), pairs = await this.blocks.get(stored.pair_block);
    const nodes = stored.nodes !== undefined ? await this.blocks.get(stored.nodes) : null;
    const bounds = stored.bounds !== undefined ? await this.blocks.get(stored.bounds) : null, lines = stored.lines !== undefined ? await this.blocks.get(stored.lines) : null;
    for (const number of [stored.outcomes, stored.pair_block, stored.nodes, stored.bounds, stored.lines]) this.blocks.forget(number);
    return new QueryFrame(this, stored, bits, pairs, nodes, bounds, lines);
  }

  /** @param {number} outcome */
  rejects(outcome) {
    return outcome >= 2 && this.stored.groups[outcome - 2].rejects;
  }

  // How a test ended, in words; and its nodes.
  /** @type {(frame: QueryFrame, test: number) => string} */
  endingOf(frame, test) {
    return frame.outcomes[test] < 2 ? 'passed' : this.stored.groups[frame.outcomes[test] - 2].label;
  }
  // Whether the tests that followed are of children of both nodes: other engines go into both at once.
  /** @type {(frame: QueryFrame, test: number) => boolean} */
  dividesBoth(frame, test) {
    const { first, next } = frame.followers;
    let [a, b] = [false, false];
    for (let i = first[test]; i >= 0; i = next[i]) {
      a ||= frame.a[i] !== frame.a[test];
      b ||= frame.b[i] !== frame.b[test];
    }
    return a && b;
  }
  /** @type {(frame: QueryFrame, test: number) => string} */
  pairText(frame, test) {
    return `${this.trees[0].numberOf(frame.a[test])},${this.trees[1].numberOf(frame.b[test])}`;
  }

  // The tests of a class of verdicts, or those that were left out, by their bounds: the nearest to the answer first.
  /** @type {(frame: QueryFrame, wanted: (test: number) => boolean) => number[]} */
  byBound({ bounds, stored: { distance = 0 } }, wanted) {
    const away = (/** @type {number} */ i) => Math.abs((bounds?.[i] ?? 0) - distance);
    return bounds ? [...bounds.keys()].filter(wanted).sort((x, y) => away(x) - away(y) || x - y) : [];
  }

  // The test that rejected two slots, or nodes above them; -1: none did.
  /** @type {(frame: QueryFrame, ...slots: number[]) => number} */
  lostAt(frame, ...slots) {
    const above = slots.map((slot, side) => {
      const chain = new Set();
      for (let at = slot; at >= 0; at = this.trees[side].parent[at]) chain.add(at);
      return chain;
    });
    return frame.outcomes.findIndex((outcome, i) => this.rejects(outcome) && above[0].has(frame.a[i]) && above[1].has(frame.b[i]));
  }

  // Of each test whether its node of a side is the slot or below it.
  /** @type {(frame: QueryFrame, side: number, slot: number) => Uint8Array} */
  below(frame, side, slot) {
    const tree = this.trees[side], known = new Map();
    return Uint8Array.from(side === 0 ? frame.a : frame.b, (at) => {
      const is = known.get(at) ?? (at >= 0 && tree.isBelow(at, slot) ? 1 : 0);
      known.set(at, is);
      return is;
    });
  }

  // The tests in classes, 1 to `many`; 0: in none, and those that are not `within`. How many there are in each, and of each slot of both sides.
  /**
   * @param {QueryFrame} frame
   * @param {Uint8Array} of
   * @param {number} many
   * @param {Uint8Array | null} within
   * @returns {Classes}
   */
  classes(frame, of, many, within = null) {
    if (within) of = of.map((c, i) => (within[i] ? c : 0));
    /** @type {number[]} */
    const counts = new Array(many).fill(0);
    for (const c of of) if (c > 0) ++counts[c - 1];
    const sides = [frame.a, frame.b].map((slots) => {
      /** @type {Map<number, SlotTests>} */
      const found = new Map();
      slots.forEach((slot, i) => {
        if (slot < 0) return;
        let entry = found.get(slot);
        if (!entry) found.set(slot, (entry = { tests: 0, counts: new Uint32Array(many) }));
        ++entry.tests;
        if (of[i] > 0) ++entry.counts[of[i] - 1];
      });
      return found;
    });
    return { of, counts, sides };
  }

  // The number of the test of two slots; -1: it was not made.
  /** @type {(frame: QueryFrame, slot_a: number, slot_b: number) => number} */
  testOf(frame, slot_a, slot_b) {
    frame.places ??= new Map(Array.from(frame.a, (slot, i) => /** @type {const} */ ([slot * 2 ** 32 + frame.b[i], i])).reverse());
    return frame.places.get(slot_a * 2 ** 32 + slot_b) ?? -1;
  }

  // A promise of the steps of each test, by the number of the test; empty where the page has none.
  /**
   * @param {QueryFrame} frame
   * @returns {Promise<Record<number, Explanation>>}
   */
  async steps(frame) {
    if (frame.stored.steps === undefined) return {};
    return (frame.explained ??= JSON.parse(new TextDecoder().decode(await this.blocks.get(frame.stored.steps))));
  }

  // The tests of a slot of a side, those from which the most others followed first.
  /** @type {(frame: QueryFrame, side: number, slot: number) => number[]} */
  testsWith(frame, side, slot) {
    const { sizes } = frame.followers;
    /** @type {number[]} */
    const tests = [];
    (side === 0 ? frame.a : frame.b).forEach((of, i) => of === slot && tests.push(i));
    return tests.sort((x, y) => sizes[y] - sizes[x] || x - y);
  }

  // Of each triangle of both sides the tests of volumes that hold it; of those alone that followed from a pair below which no triangles
  // meet, where `wasted` says so. `end`: of the scale, the next of 1, 2 and 5 times a power of ten. Needs the trees' items.
  /**
   * @param {QueryFrame} frame
   * @param {boolean} wasted
   * @param {number[]} triangles how many each side has
   * @param {Uint8Array | null} within
   * @returns {Heat}
   */
  heat(frame, wasted, triangles, within = null) {
    const { parents, meets } = frame, count = parents.length;
    let total = 0, most = 0;
    const counts = [0, 1].map((side) => {
      const tree = this.trees[side], slots = side === 0 ? frame.a : frame.b, tests = new Float64Array(tree.order.length), of = new Float64Array(triangles[side]);
      for (let i = 0; i < count; ++i) {
        if ((within && !within[i]) || (wasted && (parents[i] < 0 || meets[parents[i]]))) continue;
        ++tests[slots[i]];
        total += side === 0 ? 1 : 0;
      }
      tree.parent.forEach((parent, slot) => {
        if (parent >= 0) tests[slot] += tests[parent];
        for (const item of tree.itemsOf(slot)) if (item < of.length) most = Math.max(most, (of[item] = tests[slot]));
      });
      return of;
    });
    let end = 10;
    for (let i = 0; end < most; ++i) end *= i % 3 === 1 ? 2.5 : 2;
    return { counts, most, end, total };
  }

  // The slots of a side with tests of classes that are shown, without those that have another one below: slot, the most frequent class,
  // and how many tests. `focus`: the share of the tests of both sides that has to be seen; what is large for its tests is left out.
  /** @type {(classes: Classes, shown: boolean[], focus: number) => { all: ShownNode[][], focus: number }} */
  nodesOf(classes, shown, focus) {
    const all = [0, 1].map((side) => {
      const tree = this.trees[side], holds = new Set();
      /** @type {ShownNode[]} */
      const found = [];
      for (const [slot, { counts }] of classes.sides[side]) {
        let paths = 0, best = -1;
        counts.forEach((n, group) => {
          if (!shown[group] || n === 0) return;
          paths += n;
          if (best < 0 || n > counts[best]) best = group;
        });
        if (best >= 0) found.push({ side, slot, group: best, paths });
      }
      for (const { slot } of found)
        for (let up = tree.parent[slot]; up >= 0 && !holds.has(up); up = tree.parent[up]) holds.add(up);
      // In the order of their indices, which decides between equal ones.
      return found.filter(({ slot }) => !holds.has(slot)).sort((x, y) => tree.order[x.slot] - tree.order[y.slot]);
    });
    return { all, focus };
  }

  // The nodes of `all` that are drawn; the levels of all nodes must be unpacked. `areaOf`: the area of the triangles that are drawn in place of a node, or 0.
  // `keeps`: whether all nodes of a group are drawn.
  /** @type {(found: { all: ShownNode[][], focus: number }, areaOf: (node: ShownNode) => number, keeps: (group: number) => boolean) => ShownNode[]} */
  drawn({ all, focus }, areaOf, keeps) {
    const nodes = all.flat(), size = (/** @type {ShownNode} */ node) => {
      const { side, slot } = node, volume = this.trees[side].volume(slot), d = 2 * radiusOf(volume);
      if (volume.shape === 0) return 0;
      const area = areaOf(node);
      return area > 0 ? d * Math.sqrt(2 * area) : d * d;  // as in rejections_figure.cpp
    };
    let left = (1 - focus) * nodes.reduce((sum, node) => sum + node.paths, 0);
    const order = nodes.map((node) => ({ node, share: node.paths / Math.max(size(node), 1e-300) })).sort((x, y) => x.share - y.share);
    const out = new Set();
    for (const { node } of order) {
      if (keeps(node.group)) continue;
      left -= node.paths;
      if (left < 0) break;
      out.add(node);
    }
    return nodes.filter((node) => !out.has(node));
  }

  // The slots of a side with tests of the classes that `wanted` says, and how many; those with the most first.
  /** @type {(classes: Classes, side: number, wanted: (group: number) => boolean) => number[][]} */
  mostOf(classes, side, wanted) {
    /** @type {number[][]} */
    const rows = [];
    for (const [slot, { counts }] of classes.sides[side]) {
      const n = counts.reduce((sum, count, group) => sum + (wanted(group) ? count : 0), 0);
      if (n > 0) rows.push([slot, n]);
    }
    const { numbers } = this.trees[side];
    return rows.sort((x, y) => y[1] - x[1] || numbers[x[0]] - numbers[y[0]]);
  }
}
