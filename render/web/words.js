// What can be shown, by the keys 1, 2 and so on.
/** @type {{ name: ModeName, text: string, about: string }[]} */
export const modes = [
  { name: 'levels', text: 'Levels', about: 'The volumes of a level of the hierarchies' },
  { name: 'rejections', text: 'Rejections', about: 'The nodes at which paths of the traversal ended, colored by how' },
  { name: 'pairs', text: 'Pairs', about: 'The triangles that meet, and the lines in which they do' },
  { name: 'tests', text: 'Tests', about: 'How many volume tests each triangle took part in' },
  { name: 'wasted', text: 'Wasted', about: 'Of these, the tests that followed from a pair below which no triangles meet' },
  { name: 'traversal', text: 'Traversal', about: 'Every test, above those that followed from it' },
  { name: 'verdicts', text: 'Verdicts', about: 'The nodes of pairs that passed though no triangles below them meet, or that were rejected wrongly' },
];

// The same where distances were measured.
/** @type {Partial<Record<ModeName, { text: string, about: string }>>} */
const ofDistances = {
  rejections: { text: 'Left out', about: 'The nodes at which paths of the traversal ended, colored by the direction of the largest bound' },
  pairs: { text: 'Distance', about: 'The closest triangles, and the line between their closest points' },
  wasted: { text: 'Wasted', about: 'Of these, the tests that followed from a pair below which no triangles are as near as the answer' },
  verdicts: { text: 'Verdicts', about: 'The nodes of pairs that were divided though no triangles below them are as near as the answer' },
};
/** @type {(app: App) => typeof modes} */
export const modesOf = (app) => (app.measures ? modes.map((mode) => ({ ...mode, ...ofDistances[mode.name] })) : modes);

// What words of the field mean.
/** @type {Record<string, string>} */
export const terms = {
  'N_v': 'tests of two volumes',
  'N_p': 'tests of two triangles',
  'passed on': 'pairs that overlap, or have a small bound, whose children were tested next; pairs of leaves, whose triangles were tested, are not among them',
  'pairs': 'pairs of triangles that meet',
  'wasted N_v': 'volume tests that followed from a pair below which no triangles meet, or are as near as the answer',
  'overlapping pairs': 'pairs of a volume of A\u2019s level and one of B\u2019s that overlap, below pairs that overlap on the level above. A level of none shows a gap; where even the leaves overlap, their triangles may still not meet',
  'mean d': 'mean diameter of the volumes, 2r',
  'mean \u03c4': 'mean thickness of the volumes, e \u2212 f',
  'area': 'surface area of all volumes together',
  'volume': 'volume of all volumes together',
  'slack': 'by how much the step separates the two: positive if it does. Other directions may separate them by more: the gap',
  'gap': 'how far apart the two volumes are, in whatever direction; of whatever test',
  'depth of overlap': 'how far one of them has to move until they no longer overlap',
  'bound': 'the two volumes are at least so far apart',
  'bound below the distance': 'divided in vain: no triangles below are as near as the answer, and the bound does not say so',
  'before it was known': 'divided in vain: the bound is above the distance, which the query did not know yet',
  'fit too loose': 'the volumes meet, but no triangles below them do',
  'test too weak': 'the volumes do not meet, but the test let them pass',
  'rejected wrongly': 'the test rejected volumes that overlap, or that hold triangles that meet',
  'c': 'center', 'r': 'radius of the ball', 'n': 'normal of the planes', 'e': 'height of the upper plane above the center', 'f': 'height of the lower plane',
  'n\u2033': 'normal of the second slab', 'e\u2033': 'height of its upper plane', 'f\u2033': 'height of its lower plane',
};
// Those that the help explains.
export const concepts = ['N_v', 'N_p', 'wasted N_v', 'overlapping pairs', 'fit too loose', 'test too weak', 'rejected wrongly', 'slack', 'gap'];

export const keysOf = (/** @type {App} */ app) => [
  ['1 to 7', modesOf(app).map(({ text }) => text.toLowerCase()).join(', ')],
  ['arrows', 'turn; with Shift, move'],
  ['+ \u2212', 'nearer, farther'],
  ['[ ]', 'one level up, down'],
  [', .', 'one frame back, on'],
  ['Space', 'play the frames'],
  ['X Y Z', 'look along an axis; with Shift, from the other side'],
  ['F', 'fit'],
  ['O', 'orthographic or perspective'],
  ['M', 'the meshes'],
  ['E', 'edges of the meshes'],
  ['K', 'a plane that cuts'],
  ['D', 'outlines of what differs'],
  ['T', 'light or dark'],
  ['P', 'the parent of the node'],
  ['C', 'its first child'],
  ['N', 'its next sibling'],
  ['A', 'go to the node that is chosen, or to what is marked'],
  ['I', 'only what is below the node'],
  ['/', 'search a node, or a test'],
  ['V', 'the traversal by how tests ended, or by what they were worth'],
  ['in the traversal', 'Tab to icicle or matrix, arrows from test to test, Enter enlarges one, or leads back'],
  ['S', 'save a PNG'],
  ['G', 'save the volumes as GLB'],
  ['Esc', 'nothing chosen'],
  ['H', 'this help'],
];
