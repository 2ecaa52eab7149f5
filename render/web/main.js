// The page: what is shown, and who hears what. What is shown is in the address, so that a link opens the same view.
class App {
  constructor() {
    this.manifest = JSON.parse(document.getElementById('manifest').textContent);
    this.canvas = document.getElementById('canvas');
    this.blocks = new Blocks();
    const { manifest } = this;
    this.state = { ...manifest.start, levels: {}, selected: null, isolated: false, orthographic: manifest.camera.orthographic };
    this.view = new View(manifest.camera, manifest.up);
    this.cache = new Map();
    this.queued = false;
    this.playing = false;
  }

  async start() {
    this.painter = new Painter(this.canvas, await Promise.all(this.manifest.grids.map((grid) => this.blocks.get(grid))));
    this.canvas.app = this;  // for scripts
    this.trees = this.manifest.trees.map((told) => new Tree(this.painter.gl, this.blocks, told));
    this.depth = Math.max(...this.trees.map((tree) => tree.depth));
    await Promise.all(this.trees.map((tree) => tree.open()));
    this.poses = await Promise.all(this.manifest.bodies.map((body) => this.blocks.get(body.poses)));
    document.documentElement.classList.add('draws');
    this.readAddress();
    this.panel = new Panel(this);
    this.listen();
    await this.refresh();
    document.documentElement.dataset.ready = 'true';
  }

  treeOf(kind, body) {
    return this.trees[this.manifest.bodies[body].trees[kind]];
  }
  levelOf(body) {
    return this.state.levels[body] ?? this.state.level;
  }
  poseOf(body) {
    const p = this.poses[body].subarray(12 * this.state.at, 12 * this.state.at + 12);
    return { rotation: [0, 1, 2].map((i) => [p[i], p[4 + i], p[8 + i]]), translation: [p[3], p[7], p[11]] };
  }
  // In the world.
  ballOf(body) {
    const tree = this.treeOf(0, body).told, pose = this.poseOf(body);
    return { center: add(times(pose.rotation, tree.center), pose.translation), radius: tree.radius };
  }

  // Changes what is shown, and shows it.
  set(change) {
    if ('level' in change) this.state.levels = {};
    Object.assign(this.state, change);
    this.state.level = clamp(this.state.level, 0, this.depth);
    this.state.at = clamp(this.state.at, 0, this.manifest.frames.length - 1);
    if (!this.state.selected) this.state.isolated = false;
    this.view.orthographic = this.state.orthographic;
    this.cache.clear();
    return this.refresh();
  }

  // Unpacks what is needed, then draws; what was asked for in the meantime wins.
  async refresh() {
    const turn = (this.turn = (this.turn ?? 0) + 1);
    this.unpacked = false;
    const { bodies, kinds } = this.manifest;
    const selected = this.state.selected ? this.treeOf(0, this.state.selected.body).levelOf(this.state.selected.slot) : 0;
    const needed = [];
    bodies.forEach((body, b) => kinds.forEach((_, k) => needed.push(this.treeOf(k, b).load(Math.max(this.levelOf(b), selected)))));
    if (this.state.mesh || this.state.edges) needed.push(this.loadMeshes());
    try {
      await Promise.all(needed);
    } catch (error) {
      this.panel.node.replaceChildren(element('p', { textContent: error.message }));
      return;
    }
    if (turn !== this.turn) return;
    this.unpacked = true;
    document.documentElement.dataset.theme = this.state.theme;
    this.panel.update();
    this.writeAddress();
    this.ask();
  }

  loadMeshes() {
    this.meshes ??= Promise.all(this.manifest.meshes.map(async (mesh) => this.painter.uploadMesh(await this.blocks.get(mesh.positions), await this.blocks.get(mesh.indices))))
      .then((uploaded) => (this.uploaded = uploaded));
    return this.meshes;
  }

  ask() {
    if (this.queued || !this.unpacked) return;
    this.queued = true;
    requestAnimationFrame(() => {
      this.queued = false;
      if (this.unpacked) this.draw();
    });
  }

  // The volumes of a body of a kind, as runs of one shape: place, color and id of each.
  groupsOf(kind, body) {
    const key = `${kind} ${body}`;
    if (this.cache.has(key)) return this.cache.get(key);
    const tree = this.treeOf(kind, body), { selected, isolated, opacity } = this.state;
    const own = selected?.body === body ? selected.slot : -1;
    const root = isolated && selected ? (own >= 0 ? own : Infinity) : -1;
    const alpha = Math.round(255 * opacity), byShape = shapeNames.map(() => []);
    const slots = root === Infinity ? [] : tree.cover(Math.max(this.levelOf(body), isolated ? tree.levelOf(own) : 0), root);
    const accent = this.manifest.themes[this.state.theme].accent;
    const put = (slot, color, transparency) => {
      const { shape, color: usual } = tree.volume(slot), [r, g, b] = color ?? usual;
      if (shape > 0) byShape[shape].push(slot, (r | (g << 8) | (b << 16) | (transparency << 24)) >>> 0, this.manifest.bodies[body].first_id + tree.order[slot]);
    };
    for (const slot of slots) if (slot !== own || isolated) put(slot, null, alpha);
    if (own >= 0 && !isolated) put(own, accent, Math.max(alpha, 64));
    const groups = byShape.map((words, shape) => ({ tree, body, shape, words: Uint32Array.from(words), count: words.length / 3 })).filter((group) => group.count > 0);
    this.cache.set(key, groups);
    return groups;
  }

  draw() {
    const { canvas, manifest, state, view } = this, ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    this.painter.resize(width, height, width * height <= 2.2e6 ? 2 : 1);
    const { samples } = this.painter, many = manifest.kinds.length, theme = manifest.themes[state.theme];
    const across = width >= height, balls = manifest.bodies.map((_, b) => this.ballOf(b));
    const middle = balls.reduce((sum, ball) => Math.max(sum, length(subtract(ball.center, view.target)) + ball.radius), 0);
    view.standBack = 2 * middle + view.distance;
    this.rectangles = manifest.kinds.map((_, k) => {
      const part = (n) => [Math.round((n * k) / many), Math.round((n * (k + 1)) / many)];
      const [x0, x1] = across ? part(width) : [0, width], [y0, y1] = across ? [0, height] : part(height);
      return [x0, y0, x1 - x0, y1 - y0];  // from the top left
    });
    view.holdIn(this.rectangles[0][2], this.rectangles[0][3]);
    const panes = manifest.kinds.map((_, k) => {
      const [x, y, w, h] = this.rectangles[k], rectangle = [x, height - y - h, w, h].map((n) => n * samples);
      const eye = view.eye(rectangle, samples, balls);
      const lists = [[], []];
      manifest.bodies.forEach((body, b) => {
        const pose = this.poseOf(b);
        for (const group of this.groupsOf(k, b))
          lists[state.opacity >= 1 ? 0 : 1].push({ ...group, pose, placement: view.placement(pose, group.tree.told.center, eye.far) });
      });
      const list = (groups) => {
        const words = new Uint32Array(groups.reduce((sum, group) => sum + group.words.length, 0));
        groups.reduce((at, group) => (words.set(group.words, at), at + group.words.length), 0);
        return { groups, words, count: words.length / 3 };
      };
      const meshes = (state.mesh || state.edges) && this.uploaded
        ? manifest.bodies.filter((body) => body.mesh !== null).map((body) => ({
          mesh: this.uploaded[body.mesh], color: theme.mesh, edges: state.edges, fade: 0,
          placement: view.placement(this.poseOf(manifest.bodies.indexOf(body)), manifest.meshes[body.mesh].center, eye.far),
        }))
        : [];
      return { rectangle, background: theme.background, view, eye, meshes, opaque: list(lists[0]), translucent: list(state.opacity > 0 ? lists[1] : []) };
    });
    this.painter.draw(panes);
    this.drawLabels(ratio);
  }

  drawLabels(ratio) {
    const labels = document.getElementById('labels'), { kinds } = this.manifest;
    labels.replaceChildren(...(kinds.length > 1 ? kinds : []).map((kind, k) => {
      const label = element('span', { textContent: kind.title });
      label.style.left = `${this.rectangles[k][0] / ratio + 6}px`;
      label.style.top = `${this.rectangles[k][1] / ratio + 4}px`;
      return label;
    }));
    // A round length of at most a fifth of the view, at the target.
    const height = this.rectangles[0][3] / ratio, world = this.view.pixel(height), most = (this.rectangles[0][2] / ratio) * 0.2 * world;
    const power = 10 ** Math.floor(Math.log10(most)), size = [5, 2, 1].map((n) => n * power).find((n) => n <= most) ?? power;
    const bar = document.getElementById('bar');
    bar.firstElementChild.textContent = short(size);
    bar.lastElementChild.style.width = `${size / world}px`;
  }

  // Counts of the level that is shown.
  counts() {
    const { bodies, kinds } = this.manifest, rows = [];
    bodies.forEach((body, b) => {
      const tree = this.treeOf(0, b), level = Math.min(this.levelOf(b), tree.depth);
      rows.push([`${bodies.length > 1 ? `${body.name}, ` : ''}volumes at level ${level} of ${tree.depth}`, counted(tree.cover(level).length)]);
    });
    return rows;
  }

  command() {
    const { manifest, state } = this;
    return `${manifest.command}${manifest.up[2] === 1 ? ` --camera orbit:${this.view.orbit_angles}` : ''} --levels ${state.level} --opacity ${+state.opacity.toFixed(2)}${state.mesh ? ' --mesh' : ''}${state.edges ? ' --edges' : ''}` +
      `${manifest.frames.length > 1 ? ` --frames ${manifest.frames[state.at]}` : ''}${state.orthographic ? ' --ortho' : ''}${state.theme === 'dark' ? ' --background dark' : ''} -o out/`;
  }

  // What is at a point of the canvas, in pixels of the page.
  pick(x, y) {
    const ratio = this.canvas.width / this.canvas.clientWidth, px = Math.floor(x * ratio), py = Math.floor(y * ratio);
    const id = this.painter.idAt(px, py), { bodies } = this.manifest;
    for (let b = bodies.length - 1; b >= 0 && id > 0; --b)
      if (id >= bodies[b].first_id) return { body: b, slot: this.treeOf(0, b).slotOf(id - bodies[b].first_id), id };
    return null;
  }

  select(body, slot) {
    return this.set({ selected: slot >= 0 ? { body, slot } : null });
  }

  find(text) {
    const { bodies } = this.manifest, at = text.lastIndexOf(':');
    const name = at < 0 ? null : text.slice(0, at).trim(), node = Number(text.slice(at + 1).trim());
    const body = name === null ? 0 : bodies.findIndex((b) => b.name === name);
    const slot = body >= 0 && text.trim() !== '' && Number.isInteger(node) ? this.treeOf(0, body).slotOf(node) : -1;
    if (slot >= 0) return this.select(body, slot);
    this.panel.node.replaceChildren(element('p', { textContent: `There is no node ${text}.` }));
  }

  fit() {
    const balls = this.manifest.bodies.map((_, b) => this.ballOf(b));
    const center = scaled(1 / balls.length, balls.map((ball) => ball.center).reduce(add));
    const radius = Math.max(...balls.map((ball) => length(subtract(ball.center, center)) + ball.radius));
    const [, , width, height] = this.rectangles[0];
    this.view.fit({ center, radius }, width / height);
    this.refresh();
  }
  along(axis, sign) {
    this.view.along([0, 1, 2].map((i) => (i === axis ? sign : 0)));
    this.refresh();
  }
  play() {
    this.playing = !this.playing;
    const step = () => {
      if (!this.playing) return;
      this.set({ at: (this.state.at + 1) % this.manifest.frames.length }).then(() => setTimeout(step, 40));
    };
    step();
    this.panel.update();
  }
  save() {
    this.draw();
    this.canvas.toBlob((blob) => {
      const link = element('a', { href: URL.createObjectURL(blob), download: `${this.manifest.scene}.png` });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }
  help() {
    document.getElementById('help').showModal();
  }

  listen() {
    const { canvas } = this, pointers = new Map();
    let moved = 0;
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
      moved = 0;
    });
    canvas.addEventListener('pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const now = [event.offsetX, event.offsetY], x = now[0] - before[0], y = now[1] - before[1];
      moved += Math.abs(x) + Math.abs(y);
      if (pointers.size === 2) {
        const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
        const apart = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]);
        if (apart(now) > 0) this.view.zoom(apart(before) / apart(now));
        this.view.pan(x / 2, y / 2, canvas.clientHeight);
      } else if (event.shiftKey || event.buttons & 6) {
        this.view.pan(x, y, canvas.clientHeight);
      } else {
        this.view.orbit((x * Math.PI) / canvas.clientHeight, (y * Math.PI) / canvas.clientHeight);
      }
      pointers.set(event.pointerId, now);
      this.ask();
    });
    const up = (event) => {
      if (!pointers.delete(event.pointerId)) return;
      if (moved < 4 && event.type === 'pointerup') {
        const found = this.pick(event.offsetX, event.offsetY);
        this.select(found?.body ?? 0, found?.slot ?? -1);
      } else {
        this.writeAddress();
      }
    };
    canvas.addEventListener('pointerup', up);
    canvas.addEventListener('pointercancel', up);
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.view.zoom(Math.exp(0.0015 * event.deltaY * (event.deltaMode === 1 ? 20 : 1)));
      this.ask();
      clearTimeout(this.afterWheel);
      this.afterWheel = setTimeout(() => this.writeAddress(), 200);
    }, { passive: false });
    document.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.ask()).observe(canvas);
    window.addEventListener('hashchange', () => {
      if (location.hash === this.address) return;
      this.readAddress();
      this.cache.clear();
      this.refresh();
    });
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || document.getElementById('help').open) return;
    const { state } = this, onControl = event.target instanceof HTMLInputElement || event.target instanceof HTMLButtonElement;
    const { selected } = state, tree = selected ? this.treeOf(0, selected.body) : null;
    const go = (slot) => slot >= 0 && this.select(selected.body, slot);
    const turn = (x, y) => {
      if (event.shiftKey) this.view.pan(-200 * x, -200 * y, this.canvas.clientHeight);
      else this.view.orbit(x, y);
      this.refresh();
    };
    const zoom = (factor) => {
      this.view.zoom(factor);
      this.refresh();
    };
    const acts = {
      arrowleft: () => turn(-0.1, 0), arrowright: () => turn(0.1, 0), arrowup: () => turn(0, -0.1), arrowdown: () => turn(0, 0.1),
      '+': () => zoom(0.9), '=': () => zoom(0.9), '-': () => zoom(1 / 0.9),
      '[': () => this.set({ level: state.level - 1 }), ']': () => this.set({ level: state.level + 1 }),
      ',': () => this.set({ at: state.at - 1 }), '.': () => this.set({ at: state.at + 1 }),
      ' ': () => this.manifest.frames.length > 1 && this.play(),
      x: () => this.along(0, event.shiftKey ? -1 : 1), y: () => this.along(1, event.shiftKey ? -1 : 1), z: () => this.along(2, event.shiftKey ? -1 : 1),
      f: () => this.fit(), o: () => this.set({ orthographic: !state.orthographic }),
      m: () => this.set({ mesh: !state.mesh }), e: () => this.set({ edges: !state.edges }),
      t: () => this.set({ theme: state.theme === 'dark' ? 'light' : 'dark' }),
      p: () => selected && go(tree.parent[selected.slot]),
      c: () => selected && tree.children[selected.slot] > 0 && go(tree.firstChild[selected.slot]),
      n: () => selected && tree.parent[selected.slot + 1] === tree.parent[selected.slot] && go(selected.slot + 1),
      i: () => selected && this.set({ isolated: !state.isolated }),
      '/': () => this.panel.search.focus(), s: () => this.save(), escape: () => this.select(0, -1), h: () => this.help(), '?': () => this.help(),
    };
    const name = event.key.toLowerCase(), act = acts[name];
    // A control that has the focus has its own use for these.
    if (!act || (onControl && (name === ' ' || name.startsWith('arrow')))) return;
    event.preventDefault();
    act();
  }

  writeAddress() {
    const { state, view, manifest } = this, number = (x) => String(+x.toPrecision(7));
    const words = new URLSearchParams();
    words.set('level', state.level);
    for (const [body, level] of Object.entries(state.levels)) words.set(`level${body}`, level);
    if (manifest.frames.length > 1) words.set('frame', manifest.frames[state.at]);
    if (state.selected) {
      words.set('body', state.selected.body);
      words.set('node', this.treeOf(0, state.selected.body).order[state.selected.slot]);
    }
    if (state.isolated) words.set('only', 1);
    words.set('opacity', number(state.opacity));
    for (const name of ['mesh', 'edges', 'orthographic']) if (state[name]) words.set(name, 1);
    words.set('theme', state.theme);
    words.set('target', view.target.map(number).join());
    words.set('backward', view.axes[2].map(number).join());
    words.set('right', view.axes[0].map(number).join());
    words.set('distance', number(view.distance));
    this.address = `#${words}`;
    history.replaceState(null, '', this.address);
  }

  // What an address does not say stays as it is; what makes no sense is left out.
  readAddress() {
    const words = new URLSearchParams(location.hash.slice(1)), { state, view, manifest } = this;
    const number = (name) => (words.has(name) && Number.isFinite(Number(words.get(name))) ? Number(words.get(name)) : null);
    const vector = (name) => {
      const parts = (words.get(name) ?? '').split(',').map(Number);
      return parts.length === 3 && parts.every(Number.isFinite) ? parts : null;
    };
    if (number('level') !== null) state.level = clamp(Math.round(number('level')), 0, this.depth);
    manifest.bodies.forEach((_, b) => {
      if (number(`level${b}`) !== null) state.levels[b] = clamp(Math.round(number(`level${b}`)), 0, this.depth);
    });
    if (manifest.frames.includes(number('frame'))) state.at = manifest.frames.indexOf(number('frame'));
    const body = number('body') ?? 0;
    const slot = number('node') !== null && manifest.bodies[body] ? this.treeOf(0, body).slotOf(number('node')) : -1;
    if (words.size > 0) state.selected = slot >= 0 ? { body, slot } : null;
    state.isolated = words.has('only') && slot >= 0;
    if (number('opacity') !== null) state.opacity = clamp(number('opacity'), 0, 1);
    if (words.size > 0) for (const name of ['mesh', 'edges', 'orthographic']) if (words.has('opacity') || words.has(name)) state[name] = words.has(name);
    if (manifest.themes[words.get('theme')]) state.theme = words.get('theme');
    view.orthographic = state.orthographic;
    const [target, backward, right] = ['target', 'backward', 'right'].map(vector);
    if (target) view.target = target;
    if (backward && right && length(cross(backward, right)) > 0.1) {
      const back = unit(backward), up = unit(cross(back, right));
      view.axes = [cross(up, back), up, back];
    }
    if (number('distance') > 0) view.distance = number('distance');
  }
}

const app = new App();
app.start().catch((error) => {
  // What cannot be drawn is said, beside the still picture.
  document.documentElement.classList.remove('draws');
  document.querySelector('#instead p').textContent = `This browser cannot draw the scene (${error.message}). This is the still picture.`;
});
