// Shapes of the page's data, for the JSDoc comments of its modules.

type App = import('./main.js').App;
type Blocks = import('./blocks.js').Blocks;
type Painter = import('./painter.js').Painter;
type Program = import('./programs.js').Program;
type Query = import('./query.js').Query;
type QueryFrame = import('./query.js').QueryFrame;
type Tree = import('./tree.js').Tree;
type View = import('./camera.js').View;

type Numbers = ArrayLike<number>;
type Vector = number[];
type Color = number[]; // red, green, blue, 0 to 255
type ThemeName = 'light' | 'dark';
type ModeName = 'levels' | 'rejections' | 'pairs' | 'tests' | 'wasted' | 'traversal' | 'verdicts';
type Size = [width: number, height: number];
type Rectangle = [x: number, y: number, width: number, height: number];

interface Ball {
  center: Vector;
  radius: number;
}
interface Pose {
  rotation: Vector[]; // columns
  translation: Vector;
}
/** The half-space of the points p with normal.p <= offset. The normal has any length but 0. */
interface Clip {
  normal: Vector;
  offset: number;
}

// The manifest, see app/view/view_manifest.cpp.

/** The number of a block, whose array is a T. */
type Block<T> = number & { readonly array?: T };

interface Manifest {
  scene: string;
  commands: Partial<Record<ModeName, string[]>>;
  frames: number[];
  same_nodes: boolean;
  up: Vector;
  columns: ManifestColumn[];
  meshes: ManifestMesh[];
  trees: ManifestTree[];
  grids: Block<Float32Array>[];
  legend: { title: string; ticks: Tick[] } | null;
  viridis: Color[];
  camera: ManifestCamera;
  themes: Record<ThemeName, Theme>;
  start: { level: number; at: number; opacity: number; mesh: boolean; edges: boolean };
}
/** A place on a scale from 0 to 1, and its label. */
type Tick = [at: number, text: string];
interface Theme {
  background: Color;
  text: Color;
  faint: Color;
  mesh: Color;
}
interface ManifestCamera {
  position: Vector;
  axes: Vector[];
  orthographic: boolean;
  fov: number; // degrees
  view_height: number;
  aspect: number;
  center: Vector;
  clip: Clip | null;
}
interface ManifestMesh {
  center: Vector;
  triangles: number;
  positions: Block<Float32Array>; // n x 3, from the center
  indices: Block<Uint32Array>; // n x 3
}
interface ManifestColumn {
  title: string;
  bodies: ManifestBody[];
  verdict: string[];
  explain: string;
  several_frames: boolean;
  query: ManifestQuery | null;
}
interface ManifestBody {
  name: string;
  color: Color;
  dimmed: Record<ThemeName, Color>;
  first_id: number;
  mesh: number | null;
  tree: number;
  poses: Block<Float64Array>; // n x 12, one row a frame: the rows of [R|t]
}
/** See render/web/tree_blocks.h. */
interface ManifestTree {
  center: Vector;
  radius: number;
  levels: number[][]; // of the cover: volumes, mean d, mean thickness, area, volume
  nodes: number;
  order: Block<Uint32Array>;
  children: Block<Uint32Array>;
  item_counts: Block<Uint32Array>;
  items: Block<Uint32Array>;
  counts: number[];
  parts: ManifestPart[];
  numbers?: Block<Uint32Array>;
  names?: Block<Uint8Array>; // JSON: names by node
}
interface ManifestPart {
  levels: number;
  shapes: Block<Uint8Array>;
  numbers: Block<Float32Array>;
  colors: Block<Uint8Array>;
  extras?: Block<Uint32Array>;
  texels?: Block<Float32Array>;
}
/** See app/view/view_query.cpp. */
interface ManifestQuery {
  distance: boolean; // distances are bounded, and volumes are not tested for overlap
  objects: boolean; // pairs are of nodes, not of triangles
  symbols: string[];
  groups: EndingGroup[];
  worths: Label[];
  worst: WorstTest[][]; // per worth
  frames: ManifestFrame[];
}
interface Label extends Record<ThemeName, Color> {
  label: string;
}
interface EndingGroup extends Label {
  stages: string;
  triangles: boolean;
  meet: boolean;
  rejects: boolean;
}
interface WorstTest {
  frame: number;
  test: number;
  nodes: number[];
  n_v?: number;
  n_p?: number;
  missed?: number;
}
/** See render/web/query_blocks.h. */
interface ManifestFrame {
  frame: number;
  n_v: number;
  n_p: number;
  pairs: number;
  judged: boolean;
  wasted: number;
  overlaps: number[]; // per level
  outcomes: Block<Uint8Array>;
  pair_block: Block<Uint32Array>;
  nodes?: Block<Uint32Array>;
  // Of distances.
  distance?: number;
  bounds?: Block<Float32Array>; // per test: the lower bound
  lines?: Block<Float64Array>; // per pair: its closest points, in A's frame
  steps?: Block<Uint8Array>; // JSON: Explanation by test
}
interface Explanation {
  exact: string;
  answer: string;
  room?: number;
  steps: Step[];
}
interface Step {
  stage: string;
  formula: string;
  slack: number;
  rejects: boolean;
  not_tried?: string;
  error?: string;
}

// What is drawn.

/** The levels of a tree that were unpacked together. Slots are `first` to before `last`. */
interface TreePart {
  shapes: Uint8Array;
  numbers: Float32Array;
  offsets: Uint32Array; // per slot, into numbers
  colors: Uint8Array;
  texels: Float32Array; // n x 16
  extraTexels: Float32Array; // n x 4: planes or points
  first: number;
  last: number;
  extrasEnd: number; // extras of all parts so far
  end: number; // the first level behind it
}
interface Volume {
  shape: number; // index of shapeNames
  numbers: Float32Array;
  color: Uint8Array;
  extras: number; // planes or points
}
interface Placement {
  to_eye: number[];
  origin: Vector;
  scale: number;
  columns: Vector[];
}
interface Eye {
  far: number;
  uniforms: {
    orthographic: number;
    half_view: number[];
    near_plane: number;
    target: number[];
    pixel: number;
    line_scale: number;
    clip: number[];
  };
}
/** What Painter.uploadMesh and uploadSegments return. */
interface Upload {
  array: WebGLVertexArrayObject | null;
  count: number;
  buffers: (WebGLBuffer | null)[];
  colored?: boolean;
}
interface DrawnMesh {
  mesh: Upload;
  placement: Placement;
  color: Color;
  edges?: boolean;
  fade?: number; // share of the background
  hatched?: boolean;
  shading?: number;
  first_id?: number; // of its first triangle
  backdrop?: boolean; // behind all else
  shine_through?: number; // opacity of what something hides
}
interface DrawnSegments {
  segments: Upload;
  placement: Placement;
  color: Color;
  width: number;
  on_top: boolean;
  dashed?: boolean;
  lift?: number; // pixels by which it is drawn nearer
}
interface PaintedNode {
  slot: number;
  color: Numbers;
  opacity: number; // 0 to 255
  bits: number; // of the id
}
/** Volumes of one shape and tree. */
interface VolumeGroup {
  tree: Tree;
  body: number;
  shape: number;
  words: Uint32Array; // n x 3: slot, color with opacity, id
  centers: Float32Array; // n x 3
  count: number;
}
interface PlacedGroup extends VolumeGroup {
  pose: Pose;
  placement: Placement;
}
interface VolumeList {
  groups: PlacedGroup[];
  words: Uint32Array;
  count: number;
  drawn?: Uint32Array; // the words, sorted
  runs?: { group: PlacedGroup; first: number; count: number }[];
}
interface PaneContent {
  meshes: DrawnMesh[];
  segments: DrawnSegments[];
  opaque: VolumeGroup[];
  translucent: VolumeGroup[];
  shining: VolumeGroup[]; // seen through what hides them
}
interface Pane {
  meshes: DrawnMesh[];
  segments: DrawnSegments[];
  opaque: VolumeList;
  translucent: VolumeList;
  shining: VolumeList;
  rectangle: Rectangle; // of the target, from the bottom left
  background: Color;
  view: View;
  eye: Eye;
}

/** A triangle mesh. */
interface Solid {
  positions: number[]; // n x 3
  indices: number[]; // n x 3
}
interface GlbMesh extends Solid {
  name: string;
  color: Numbers;
  opacity: number;
  pose: Pose;
  center: Vector; // positions count from it
  id: number;
  depth: number;
}

// Queries. Side 0 is A, side 1 is B; a slot is the place of a node in its tree.

interface ColumnBody extends Omit<ManifestBody, 'tree' | 'poses'> {
  tree: Tree;
  poses: Float64Array;
}
interface Column extends Omit<ManifestColumn, 'bodies' | 'query'> {
  bodies: ColumnBody[];
  query: Query | null;
}
/** Tests in classes 1 to n, by how they ended or by what they were worth; 0: in none. */
interface Classes {
  of: Uint8Array; // per test
  counts: number[]; // per class, from class 1 on
  sides: Map<number, SlotTests>[]; // per side, by slot
}
interface SlotTests {
  tests: number;
  counts: Uint32Array; // per class
}
/** What followed from each test. */
interface Followers {
  sizes: Uint32Array; // the test, and all that followed
  dominant: Int32Array; // the most frequent ending among these; -1: none
  first: Int32Array; // the first test that follows; -1: none
  next: Int32Array; // the next one that follows from the same test
}
/** Tests of nodes of two depths, A's and B's. */
interface Cell {
  x: number;
  y: number;
  tests: number;
  rejected: number;
}
interface Cells {
  all: Map<string, Cell>; // by "x,y"
  wide: number;
  high: number;
  most: number; // tests of a cell
}
interface ShownNode {
  side: number;
  slot: number;
  group: number; // the most frequent class, from 0; -1: a node of a test, in no class
  paths: number; // tests of classes that are shown
}
/** Tests by triangle. */
interface Heat {
  counts: Float64Array[]; // per side, by triangle
  most: number;
  end: number; // of the scale
  total: number;
}

// What is shown.

/** A node, and a triangle of its mesh if one was chosen. */
interface SelectedNode {
  column: number;
  body: number;
  slot: number;
  triangle: number | null;
}
interface State {
  mode: ModeName;
  level: number;
  levels: Record<number, number>; // by body, where it is not `level`
  at: number; // index of Manifest.frames
  opacity: number;
  mesh: boolean;
  edges: boolean;
  theme: ThemeName;
  hidden: string[]; // labels of classes
  without: number[]; // bodies
  focus: number; // share of the tests whose nodes are drawn
  differences: boolean;
  column: number;
  orthographic: boolean;
  clip: Clip | null;
  selected: SelectedNode | null;
  isolated: boolean; // only what is below the selected node
  pair: number[] | null; // two triangles that meet, and the column that found them
  // Of the traversal; -1: none.
  test: number;
  hover: number;
  root: number; // the test that fills the width
  cell: number[] | null; // depths of the matrix
  by: 'ending' | 'worth';
}
/** The line in which two triangles meet, or between their closest points. */
interface Contact {
  pair: number[];
  line: number[]; // two points, from the middle of A's tree
}
/** Triangles of one side that are drawn by themselves. */
interface TrianglePart {
  side: number;
  differs: boolean;
  triangles: number[];
  mesh: Upload;
}
/** A column at the frame that is shown. What a mode does not show is missing. */
interface Scene {
  frame: QueryFrame | null;
  within?: Uint8Array | null; // per test: whether it is below the isolated node
  steps?: Record<number, Explanation>;
  heat?: Heat;
  classes?: Classes;
  nodes?: ShownNode[];
  all?: number; // nodes before some are left out
  pairs?: Uint32Array;
  meeting?: Set<number>[]; // triangles per side
  parts?: TrianglePart[];
  contacts?: Contact[];
  lines?: Upload | null;
  chosenLine?: Upload | null;
  differing?: Set<ShownNode>;
}
/** Per column; and the slots of the leaves of the pair that was chosen, per side. */
type Scenes = Scene[] & { leaves: number[] | null };
/** What is at a point of the canvas. */
type Picked = { column: number } & ({ pair: number[] } | { body: number; triangle: number } | { body: number; slot: number });
