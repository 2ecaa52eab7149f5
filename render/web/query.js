// The line in which two triangles meet, by its ends; nothing where they lie in one plane.
function lineOf(a, b) {
  const normal = (t) => cross(subtract(t[1], t[0]), subtract(t[2], t[0])), line = cross(normal(a), normal(b));
  // Where the edges of a triangle cross the plane of the other one.
  const crossings = (t, plane) => {
    const n = normal(plane), heights = t.map((p) => dot(n, subtract(p, plane[0]))), points = [];
    for (let i = 0; i < 3; ++i) {
      const k = (i + 1) % 3, [u, v] = [heights[i], heights[k]];
      if (u === 0) points.push(t[i]);
      else if (u * v < 0) points.push(add(t[i], scaled(u / (u - v), subtract(t[k], t[i]))));
    }
    return points.map((point) => ({ at: dot(line, point), point })).sort((x, y) => x.at - y.at);
  };
  const of_a = crossings(a, b), of_b = crossings(b, a);
  if (of_a.length === 0 || of_b.length === 0 || length(line) === 0) return null;
  const from = of_a[0].at > of_b[0].at ? of_a[0] : of_b[0], to = of_a.at(-1).at < of_b.at(-1).at ? of_a.at(-1) : of_b.at(-1);
  return from.at <= to.at ? [from.point, to.point] : null;
}

// The tests of a query by one kind of volumes, frame by frame. Nodes are slots of their trees.
class Query {
  constructor(blocks, told, trees) {
    Object.assign(this, { blocks, told, trees });
    this.frames = new Map(told.frames.map((frame) => [frame.frame, frame]));
    this.unpacked = new Map();
  }

  // A promise of what there is of a frame; null where the page does not have its query.
  get(number) {
    const told = this.frames.get(number);
    if (!told) return Promise.resolve(null);
    if (!this.unpacked.has(number)) {
      this.unpacked.clear();  // one frame at a time
      this.unpacked.set(number, this.unpack(told));
    }
    return this.unpacked.get(number);
  }

  async unpack(told) {
    const outcomes = await this.blocks.get(told.outcomes), pairs = await this.blocks.get(told.pair_block);
    const nodes = 'nodes' in told ? await this.blocks.get(told.nodes) : null;
    for (const number of [told.outcomes, told.pair_block, told.nodes]) this.blocks.forget(number);
    const count = outcomes.length, a = new Uint32Array(count), b = new Uint32Array(count), parents = new Int32Array(count).fill(-1);
    if (nodes) {
      for (let i = 0; i < count; ++i) {
        a[i] = this.trees[0].slotOf(nodes[3 * i]);
        b[i] = this.trees[1].slotOf(nodes[3 * i + 1]);
        parents[i] = nodes[3 * i + 2] | 0;  // none is -1
      }
    } else {
      // As the query went on: first the roots, then all children of the pair that was divided last.
      const divided = [];
      let next = 0;
      const visit = (slot_a, slot_b, parent) => {
        parents[next] = parent;
        a[next] = slot_a;
        b[next] = slot_b;
        if (outcomes[next] < 2) divided.push(next);
        ++next;
      };
      if (count > 0) visit(0, 0, -1);
      while (divided.length > 0) {
        const test = divided.pop(), of_a = outcomes[test] === 0, slot = of_a ? a[test] : b[test], tree = this.trees[of_a ? 0 : 1];
        const first = tree.firstChild[slot], end = first + tree.children[slot];
        for (let child = first; child < end; ++child) of_a ? visit(child, b[test], test) : visit(a[test], child, test);
      }
    }
    const frame = { told, outcomes, a, b, parents, pairs };
    frame.sides = [0, 1].map((side) => this.tally(side === 0 ? a : b, outcomes));
    frame.counts = new Array(this.told.groups.length).fill(0);
    for (const outcome of outcomes) if (outcome > 1) ++frame.counts[outcome - 2];
    frame.meeting = [0, 1].map((side) => new Set(pairs.filter((_, i) => i % 2 === side)));
    return frame;
  }

  // Per slot: all its tests, and how many of them ended in each group.
  tally(slots, outcomes) {
    const of = new Map(), groups = this.told.groups.length;
    slots.forEach((slot, i) => {
      let entry = of.get(slot);
      if (!entry) of.set(slot, (entry = { tests: 0, ended: new Uint32Array(groups) }));
      ++entry.tests;
      if (outcomes[i] > 1) ++entry.ended[outcomes[i] - 2];
    });
    return of;
  }

  // Of each triangle of both sides the tests of volumes that hold it; of those alone that followed from a pair below which no triangles
  // meet, where `wasted` says so. `end`: of the scale, the next of 1, 2 and 5 times a power of ten. Needs the trees' items.
  heat(frame, wasted, triangles) {
    const { outcomes, parents } = frame, count = outcomes.length, meets = new Uint8Array(count);
    const found = new Set(this.told.groups.flatMap(({ finds }, i) => (finds ? [i + 2] : [])));
    for (let i = count - 1; i >= 0; --i) {
      if (found.has(outcomes[i])) meets[i] = 1;
      if (meets[i] && parents[i] >= 0) meets[parents[i]] = 1;
    }
    let total = 0, most = 0;
    const counts = [0, 1].map((side) => {
      const tree = this.trees[side], slots = side === 0 ? frame.a : frame.b, tests = new Float64Array(tree.order.length), of = new Float64Array(triangles[side]);
      for (let i = 0; i < count; ++i) {
        if (wasted && (parents[i] < 0 || meets[parents[i]])) continue;
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

  // The slots of a side at which paths ended in groups that are shown, without those that have another one below: slot, the most frequent
  // ending, and how many paths ended. `focus`: the share of the paths of both sides that has to be seen; what is large for its paths is left out.
  ended(frame, shown, focus) {
    const all = [0, 1].map((side) => {
      const tree = this.trees[side], found = [], holds = new Set();
      for (const [slot, { ended }] of frame.sides[side]) {
        let paths = 0, best = -1;
        ended.forEach((n, group) => {
          if (!shown[group] || n === 0) return;
          paths += n;
          if (best < 0 || n > ended[best]) best = group;
        });
        if (best >= 0) found.push({ side, slot, group: best, paths });
      }
      for (const { slot } of found)
        for (let up = tree.parent[slot]; up >= 0 && !holds.has(up); up = tree.parent[up]) holds.add(up);
      // In the order of their numbers, which decides between equal ones.
      return found.filter(({ slot }) => !holds.has(slot)).sort((x, y) => tree.order[x.slot] - tree.order[y.slot]);
    });
    return { all, focus };
  }

  // Of these, those that are drawn: their levels must be unpacked. `areaOf`: that of the triangles that are drawn in place of a node, or 0.
  drawn({ all, focus }, areaOf) {
    const nodes = all.flat(), size = ({ side, slot, group }) => {
      const { shape, numbers } = this.trees[side].volume(slot);
      if (shape === 0) return 0;
      const d = shapeNames[shape] === 'box' ? 2 * Math.hypot(numbers[3], numbers[7], numbers[11]) : 2 * numbers[3];
      const area = areaOf({ side, slot, group });
      return area > 0 ? d * Math.sqrt(2 * area) : d * d;  // as in rejections_figure.cpp
    };
    let left = (1 - focus) * nodes.reduce((sum, node) => sum + node.paths, 0);
    const order = nodes.map((node) => ({ node, share: node.paths / Math.max(size(node), 1e-300) })).sort((x, y) => x.share - y.share);
    const out = new Set();
    for (const { node } of order) {
      left -= node.paths;
      if (left < 0) break;
      out.add(node);
    }
    return nodes.filter((node) => !out.has(node));
  }

  // The slots of a side with the most tests that ended in a rejection, and how many.
  mostRejected(frame, side, most) {
    const rejects = this.told.groups.map((group) => group.rejects), rows = [];
    for (const [slot, { ended }] of frame.sides[side]) {
      const n = ended.reduce((sum, count, group) => sum + (rejects[group] ? count : 0), 0);
      if (n > 0) rows.push([slot, n]);
    }
    const { order } = this.trees[side];
    return rows.sort((x, y) => y[1] - x[1] || order[x[0]] - order[y[0]]).slice(0, most);
  }

  // How the tests of a node ended: label and count of each group, and how many were passed on.
  testsOf(frame, side, slot) {
    const entry = frame.sides[side].get(slot);
    if (!entry) return [];
    const rows = this.told.groups.map((group, i) => [group, entry.ended[i]]).filter(([, n]) => n > 0);
    const passed = entry.tests - rows.reduce((sum, [, n]) => sum + n, 0);
    return { tests: entry.tests, rows, passed };
  }
}
