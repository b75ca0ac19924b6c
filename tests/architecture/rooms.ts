/** What a room may know: other rooms by a folder's index.ts, packages, and whether it is pure. */
export interface Room {
  readonly knows: readonly string[];
  /** null: whatever package.json lists as a dependency */
  readonly packages: readonly string[] | null;
  /** Bundled when the package is built, so that development dependencies are dependencies here. */
  readonly bundled?: boolean;
  /** Pure: no Node, no DOM, no clock, no randomness, and arithmetic that every JavaScript engine does alike. */
  readonly pure: boolean;
  /** Pure, but for people's eyes: sine and cosine are allowed, no result depends on them. */
  readonly drawing?: boolean;
}

export const ROOMS: Readonly<Record<string, Room>> = {
  schema: { knows: [], packages: ['zod'], pure: true },
  engine: { knows: ['schema'], packages: ['flatbush', 'kdbush'], pure: true },
  game: { knows: ['schema', 'engine'], packages: ['@noble/hashes'], pure: true },
  phaser: { knows: ['schema', 'engine', 'game'], packages: ['phaser'], pure: false },
  solver: { knows: ['schema', 'engine'], packages: ['flatbush', 'kdbush'], pure: true },
  check: { knows: ['schema', 'engine', 'game', 'solver'], packages: [], pure: true },
  picture: { knows: ['schema', 'engine'], packages: [], pure: true, drawing: true },
  review: { knows: ['schema', 'engine', 'solver', 'check', 'picture'], packages: [], pure: true, drawing: true },
  cli: { knows: ['schema', 'engine', 'game', 'solver', 'check', 'picture', 'review'], packages: null, pure: false },
  editor: {
    knows: ['schema', 'engine', 'game', 'phaser', 'solver', 'check', 'picture', 'review'],
    packages: null,
    pure: false,
    bundled: true,
  },
};

/** Folders that stand on all others of their room, and who alone may know them: whoever else did would stand on itself. */
export const TOPS: Readonly<Record<string, readonly string[]>> = { 'editor/app': ['editor/main.tsx'] };

/** ECMAScript fixes these to the last bit; the rest of Math differs between engines (or between calls). */
export const PORTABLE_MATH: ReadonlySet<string> = new Set([
  ...['abs', 'sqrt', 'min', 'max', 'floor', 'ceil', 'round', 'trunc', 'sign', 'imul', 'fround', 'clz32', 'PI'],
]);

/** Globals by which a clock, a locale or the outside gets into a pure room. */
export const IMPURE_GLOBALS: ReadonlySet<string> = new Set([
  ...['Date', 'Intl', 'globalThis', 'performance', 'process', 'console', 'crypto', 'window', 'document', 'self'],
  ...['setTimeout', 'setInterval', 'queueMicrotask', 'fetch', 'require', 'Buffer', 'eval', 'Function'],
]);
