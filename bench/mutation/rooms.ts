import { existsSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';

/** What is mutated together, and the tests that should detect it: files and folders, relative to the root of the repository. */
export interface Room {
  readonly sources: readonly string[];
  /** Cheap ones first, since most mutants never get to the others. */
  readonly tests: readonly string[];
}

const server = (...names: string[]): string[] => names.map((name) => `tests/server/${name}.test.ts`);
const editor = (...names: string[]): string[] => names.map((name) => `tests/editor/${name}.test.ts`);
const robustness = (...names: string[]): string[] => names.map((name) => `tests/solver/robustness/${name}.test.ts`);
const engine = (...names: string[]): string[] => names.map((name) => `tests/engine/${name}.test.ts`);

export const ROOMS: Readonly<Record<string, Room>> = {
  'solver/verify': {
    sources: ['solver/verify'],
    tests: [
      'tests/solver/near-miss',
      ...['verify', 'proofs', 'lemmas', 'lemmas-of-ways', 'orbits'].map((name) => `tests/solver/${name}.test.ts`),
    ],
  },
  'solver/search/anytime': {
    sources: ['solver/search/anytime'],
    tests: ['tests/solver/anytime-schedule.test.ts', 'tests/solver/anytime.test.ts'],
  },
  'solver/measure/softlock': { sources: ['solver/measure/softlock'], tests: ['tests/solver/softlock.test.ts'] },
  'engine/contact': { sources: ['engine/contact.ts'], tests: engine('contact', 'near-misses') },
  'engine/continuous': {
    sources: ['motion', 'integrators', 'events', 'effects', 'continuous'].map((folder) => `engine/${folder}`),
    tests: ['tests/browsers/node.test.ts', ...engine('near-misses'), 'tests/engine', 'tests/hard-cases'],
  },
  'solver/measure/robustness': {
    sources: ['solver/measure/robustness'],
    tests: [...robustness('noise', 'any-game', 'measured', 'in-steps'), 'tests/solver/robustness'],
  },
  check: { sources: ['check'], tests: ['tests/check'] },
  schema: { sources: ['schema'], tests: ['tests/schema'] },
  'cli/serve': {
    sources: ['cli/serve'],
    tests: [
      ...server('reorder', 'changes', 'streams', 'watch', 'entries', 'ports', 'crashes', 'first-reading', 'attacks', 'api'),
      ...server('locks', 'refusals', 'disk', 'full-disk', 'leftovers', 'events', 'large', 'concurrent-writers'),
    ],
  },
  'cli/disk': { sources: ['cli/io/disk.ts'], tests: server('other-systems', 'disk', 'full-disk', 'api') },
  'editor/core/files': {
    sources: ['editor/core/files'],
    tests: [
      ...editor('merge-conflicts', 'opening-marks', 'page-token', 'page-surroundings', 'late-database', 'long-list'),
      ...editor('browser-storage', 'writer-lock', 'saver-states', 'saver', 'workspace'),
      ...editor('server-requests', 'pages', 'server-storage'),
    ],
  },
  'editor/core/document': {
    sources: ['editor/core/document'],
    tests: editor(
      ...['history', 'normalize', 'hold-operations', 'object-operations', 'document'],
      ...['marks', 'pinned-notes', 'notes', 'transform', 'copy-names', 'rules'],
    ),
  },
};

/** The files in some files and folders whose names end in `ending`. A place that does not exist is an error: it was renamed. */
export function filesIn(root: string, places: readonly string[], ending: string): string[] {
  const found = places.flatMap((place) => {
    const path = join(root, place);
    if (!existsSync(path)) throw new Error(`the rooms of bench/mutation name ${place}, which does not exist`);
    if (!statSync(path).isDirectory()) return [place];
    return readdirSync(path, { recursive: true, encoding: 'utf8' })
      .map((name) => `${place}/${name.replaceAll('\\', '/')}`)
      .filter((name) => name.endsWith(ending))
      .sort();
  });
  return [...new Set(found)];
}
