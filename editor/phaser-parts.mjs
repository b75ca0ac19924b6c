import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';

// The page draws with a fifth of Phaser. Its package has one file with everything, and its sources, a module for each part: this
// makes `import ... from 'phaser'` mean what the page needs of the sources, the same code of the same version.

/** What the page imports, by the names that Phaser exports. A name with dots is a part of a namespace. */
const EXPORTS = {
  Game: 'core/Game',
  Scene: 'scene/Scene',
  Scale: 'scale/const/SCALE_MODE_CONST',
  'GameObjects.Graphics': 'gameobjects/graphics/Graphics',
  'GameObjects.Image': 'gameobjects/image/Image',
  'GameObjects.Layer': 'gameobjects/layer/Layer',
};

/** Names of `const.js` that the page imports. */
const CONSTANTS = ['CANVAS', 'WEBGL'];

/** What `scene.add` makes, and the module that adds it. */
export const FACTORIES = {
  circle: 'gameobjects/shape/arc/ArcFactory',
  graphics: 'gameobjects/graphics/GraphicsFactory',
  image: 'gameobjects/image/ImageFactory',
  text: 'gameobjects/text/TextFactory',
  tileSprite: 'gameobjects/tilesprite/TileSpriteFactory',
};

/** What a scene can't do without: they register themselves. */
const PLUGINS = [
  'cameras/2d/CameraManager',
  'events/EventEmitter',
  'gameobjects/DisplayList',
  'gameobjects/UpdateList',
  'scene/ScenePlugin',
];

/** Modules that Phaser's core names though nothing on the page calls them: input, filters, files of textures, tilemaps. */
const LEFT_OUT = [
  /^filters\/\w+$/,
  /^gameobjects\/components\/PathFollower$/,
  /^renderer\/webgl\/renderNodes\/(BatchHandlerPointLight|DynamicTextureHandler)$/,
  /^renderer\/webgl\/renderNodes\/filters\/\w+$/,
  /^renderer\/webgl\/renderNodes\/submitter\/Submitter(MeshToQuad|Tile|TilemapGPULayer)$/,
  /^renderer\/webgl\/renderNodes\/transformer\/TransformerTile$/,
  /^renderer\/snapshot\/(Canvas|WebGL)Snapshot$/,
  /^textures\/DynamicTexture$/,
  /^textures\/parsers\/(?!index|Image)\w+$/,
];

/** A part that does nothing, for what Phaser makes without being asked. @param {string[]} methods what Phaser calls of it */
const idle = (...methods) =>
  `function Idle () { this.isRunning = false; } ${methods.map((name) => `Idle.prototype.${name} = function () { return false; };`).join(' ')}`;

/** What cameras are drawn with: the one matrix that the renderer asks for, its numbers by the same operations. */
const MATRIX = `function Matrix4 () { this.val = new Float32Array(16); }
  Matrix4.prototype.identity = function () { return this.ortho(-1, 1, -1, 1, 1, -1); };
  Matrix4.prototype.ortho = function (left, right, bottom, top, near, far) {
    var lr = 1 / (left - right || Infinity);
    var bt = 1 / (bottom - top || Infinity);
    var nf = 1 / (near - far || Infinity);
    this.val.set([-2 * lr, 0, 0, 0, 0, -2 * bt, 0, 0, 0, 0, 2 * nf, 0, (left + right) * lr, (top + bottom) * bt, (far + near) * nf, 1]);
    return this;
  };
  module.exports = Matrix4;`;

const EFFECTS = ['Fade', 'Flash', 'Pan', 'RotateTo', 'Shake', 'Zoom'];

/** Modules that are another one here: lists of which one or two entries are read, and parts that have nothing to do. */
const SHORTENED = {
  'animations/AnimationManager': `${idle()} module.exports = Idle;`,
  'animations/AnimationState': `${idle('update', 'destroy')} module.exports = Idle;`,
  'cameras/2d/effects/index': `${idle('preRender', 'update', 'reset', 'destroy', 'postRenderCanvas', 'postRenderWebGL')}
    module.exports = { ${EFFECTS.map((name) => `${name}: Idle`).join(', ')} };`,
  'core/DebugHeader': 'module.exports = function () {};',
  'data/DataManager': `${idle('reset', 'destroy')} module.exports = Idle;`,
  'device/Audio': 'module.exports = {};',
  'device/Fullscreen': 'module.exports = { available: false };',
  'device/Input': 'module.exports = {};',
  'device/Video': 'module.exports = {};',
  'gameobjects/components/FilterList': `${idle('destroy')} Idle.prototype.getActive = function () { return []; }; module.exports = Idle;`,
  'gameobjects/components/Filters': 'module.exports = {};',
  'gameobjects/components/GetBounds': 'module.exports = {};',
  'gameobjects/components/Mask': 'module.exports = {};',
  'input/InputManager': `${idle()} module.exports = Idle;`,
  'math/Matrix4': MATRIX,
  'math/index': `${idle()} module.exports = { RND: null, RandomDataGenerator: Idle };`,
  'renderer/index': "module.exports = { Events: require('./events') };",
};

/** Phaser's builds decide by these what is in them. */
const FLAGS = { CANVAS_RENDERER: true, WEBGL_RENDERER: true, WEBGL_DEBUG: false, FEATURE_SOUND: false, PLUGIN_FBINSTANT: false };

const SOURCES = join(dirname(createRequire(import.meta.url).resolve('phaser/package.json')), 'src');
const ENTRY = '\0phaser-parts';

/** The path of a module of Phaser's sources, without its ending; null for others. @param {string} id */
function partOf(id) {
  const folder = `${SOURCES.replaceAll('\\', '/')}/`;
  return id.startsWith(folder) ? id.slice(folder.length).replace(/\.js$/, '') : null;
}

const quoted = (/** @type {string} */ part) => JSON.stringify(join(SOURCES, part));

/** A module that exports what the page imports. */
function entry() {
  const names = Object.keys(EXPORTS);
  const spaces = [...new Set(names.filter((name) => name.includes('.')).map((name) => name.split('.')[0]))];
  const short = (/** @type {string} */ name) => name.replace('.', '');
  return [
    ...[...PLUGINS, ...Object.values(FACTORIES)].map((part) => `import ${quoted(part)};`),
    `import constants from ${quoted('const')};`,
    ...Object.entries(EXPORTS).map(([name, part]) => `import ${short(name)} from ${quoted(part)};`),
    `export const { ${CONSTANTS.join(', ')} } = constants;`,
    `export { ${names.filter((name) => !name.includes('.')).join(', ')} };`,
    ...spaces.map((space) => {
      const parts = names.filter((name) => name.startsWith(`${space}.`));
      return `export const ${space} = { ${parts.map((name) => `${name.split('.')[1]}: ${short(name)}`).join(', ')} };`;
    }),
  ].join('\n');
}

/** A module in the place of one that is left out: it says so where the page calls for it all the same. @param {string} part */
const absent = (part) =>
  `module.exports = function () { throw new Error(${JSON.stringify(`editor/phaser-parts.mjs leaves out ${part} of Phaser`)}); };`;

/**
 * Phaser as the page needs it.
 * @returns {import('vite').Plugin}
 */
export function phaserParts() {
  return {
    name: 'phaser-parts',
    enforce: 'pre',
    resolveId: (id) => (id === 'phaser' ? ENTRY : null),
    load(id) {
      if (id === ENTRY) return entry();
      const part = partOf(id);
      if (part === null) return null;
      if (part in SHORTENED) return SHORTENED[/** @type {keyof typeof SHORTENED} */ (part)];
      if (LEFT_OUT.some((pattern) => pattern.test(part))) return absent(part);
      const text = readFileSync(id, 'utf8');
      return Object.entries(FLAGS).reduce((code, [name, is]) => code.replaceAll(`typeof ${name}`, String(is)), text);
    },
  };
}
