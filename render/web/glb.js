import { add, subtract, scaled, times } from './linear.js';

// The bytes of a binary glTF 2.0 file; null where there are no triangles. Each mesh is stored about its own middle, and placed from a common origin, which the root node
// moves back, so that 32 bits are enough far away as well. There are no normals: viewers then show triangles as the flat ones they are.
/** @type {(meshes: GlbMesh[], title: string) => Uint8Array | null} */
export function glbOf(meshes, title) {
  const shown = meshes.filter(({ indices }) => indices.length > 0).map((mesh) => {
    const least = [0, 1, 2].map(() => Infinity), most = least.map((x) => -x);
    mesh.positions.forEach((x, i) => {
      least[i % 3] = Math.min(least[i % 3], x);
      most[i % 3] = Math.max(most[i % 3], x);
    });
    const middle = scaled(0.5, add(least, most));
    return { ...mesh, middle, place: add(times(mesh.pose.rotation, add(mesh.center, middle)), mesh.pose.translation) };
  });
  if (shown.length === 0) return null;
  const origin = scaled(1 / shown.length, shown.reduce((sum, { place }) => add(sum, place), [0, 0, 0]));
  const linear = (/** @type {number} */ byte) => (byte <= 10 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
  const floats = shown.reduce((sum, { positions }) => sum + positions.length, 0), words = shown.reduce((sum, { indices }) => sum + indices.length, 0);
  const data = new ArrayBuffer(4 * (floats + words));
  /** @type {object[]} */
  const nodes = [{ name: title, translation: origin, children: shown.map((_, i) => i + 1) }];
  /** @type {object[]} */
  const accessors = [];
  /** @type {object[]} */
  const solids = [];
  /** @type {Map<string, { at: number, material: object }>} */
  const materials = new Map();
  let float = 0, word = 0;
  for (const { name, positions, indices, color, opacity, pose, middle, place, id, depth } of shown) {
    const stored = new Float32Array(data, 4 * float, positions.length), min = [Infinity, Infinity, Infinity], max = min.map((x) => -x);
    for (let i = 0; i < stored.length; ++i) {
      stored[i] = positions[i] - middle[i % 3];
      min[i % 3] = Math.min(min[i % 3], stored[i]);
      max[i % 3] = Math.max(max[i % 3], stored[i]);
    }
    new Uint32Array(data, 4 * (floats + word), indices.length).set(indices);
    const key = `${color} ${opacity}`, pbrMetallicRoughness = { baseColorFactor: [...Array.from(color, linear), opacity], metallicFactor: 0, roughnessFactor: 0.8 };
    const painted = materials.get(key) ?? { at: materials.size, material: { name: key, pbrMetallicRoughness, alphaMode: opacity < 1 ? 'BLEND' : 'OPAQUE', doubleSided: true } };
    materials.set(key, painted);
    const matrix = [...pose.rotation.flatMap((column) => [...column, 0]), ...subtract(place, origin), 1];
    nodes.push({ name, mesh: solids.length, matrix, extras: { id, depth } });
    solids.push({ name, primitives: [{ attributes: { POSITION: accessors.length }, indices: accessors.length + 1, material: painted.at }] });
    accessors.push({ bufferView: 0, byteOffset: 4 * float, componentType: 5126, count: positions.length / 3, type: 'VEC3', min, max });
    accessors.push({ bufferView: 1, byteOffset: 4 * word, componentType: 5125, count: indices.length, type: 'SCALAR' });
    float += positions.length;
    word += indices.length;
  }
  const json = {
    asset: { version: '2.0', generator: 'scb' },
    scene: 0,
    scenes: [{ name: title, nodes: [0] }],
    accessors,
    nodes,
    meshes: solids,
    buffers: [{ byteLength: data.byteLength }],
    bufferViews: [{ buffer: 0, byteLength: 4 * floats, byteStride: 12, target: 34962 }, { buffer: 0, byteOffset: 4 * floats, byteLength: 4 * words, target: 34963 }],
    materials: [...materials.values()].map(({ material }) => material),
  };
  const text = new TextEncoder().encode(JSON.stringify(json)), padded = 4 * Math.ceil(text.length / 4);
  const file = new Uint8Array(28 + padded + data.byteLength).fill(0x20, 20, 20 + padded), header = new DataView(file.buffer);
  [0x46546c67, 2, file.length, padded, 0x4e4f534a].forEach((value, i) => header.setUint32(4 * i, value, true));
  file.set(text, 20);
  [data.byteLength, 0x004e4942].forEach((value, i) => header.setUint32(20 + padded + 4 * i, value, true));
  file.set(new Uint8Array(data), 28 + padded);
  return file;
}
