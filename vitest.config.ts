import { fileURLToPath } from 'node:url';
import { defineConfig, type TestProjectInlineConfiguration } from 'vitest/config';
import { BUILT_FILES, builtRooms } from './tests/built-rooms.ts';
import { propertySettings, QUICK_RUNS } from './tests/property-settings.ts';
import { DEEP_ONLY, deepFiles } from './tests/test-sets.ts';

// ms: no test is about time; this ends what hangs, also on a machine that is busy with something else
const PATIENCE = 600_000 * Math.max(1, propertySettings(process.env).runs);

const PROJECT = import.meta.dirname;
const IN_BROWSERS = 'tests/e2e/**/*.test.ts';
// They replace modules of Node. `vi.mock` reaches only what is loaded after it, so that each needs modules of its own.
const MOCKING = ['disk', 'full-disk', 'locks', 'other-systems', 'refusals', 'watch'].map(
  (name) => `tests/server/${name}.test.ts`,
);
// What a function allocates depends on the types that V8 has seen in it: other tests would show it more than a game does.
const ALONE = [...MOCKING, 'tests/phaser/allocation.test.ts'];

interface NodeSet {
  readonly include: string[];
  readonly exclude: string[];
  /** Those that need modules of their own. */
  readonly alone: string[];
  /** A factor for the number of runs of every property. */
  readonly runs: number;
}

/** The projects of a set that needs no browser. */
function nodeProjects(name: string, mode: string, { include, exclude, alone, runs }: NodeSet): TestProjectInlineConfiguration[] {
  const env = { TEST_SET: name, PROPERTY_RUNS: process.env.PROPERTY_RUNS ?? String(runs) };
  return [
    // The files of a worker share modules, so that those are loaded once.
    {
      extends: true,
      plugins: mode === 'built' ? [builtRooms(PROJECT)] : [],
      test: {
        ...{ name, env, include, exclude: [...exclude, ...alone], isolate: false },
        server: { deps: { external: mode === 'built' ? [BUILT_FILES] : [] } },
      },
    },
    { extends: true, test: { name: `${name}-alone`, env, include: alone, exclude } },
  ];
}

const deep = deepFiles(PROJECT);
const QUICK_SET: NodeSet = { include: ['tests/**/*.test.ts'], exclude: [IN_BROWSERS, DEEP_ONLY], alone: ALONE, runs: QUICK_RUNS };
const DEEP_SET: NodeSet = { include: deep, exclude: [], alone: ALONE.filter((path) => deep.includes(path)), runs: 1 };

export default defineConfig(({ mode }) => ({
  // properties get one seed for all, see there
  resolve: { alias: [{ find: /^fast-check$/, replacement: fileURLToPath(new URL('tests/fast-check.ts', import.meta.url)) }] },
  test: {
    projects: [
      // `npm test`
      ...nodeProjects('node', mode, QUICK_SET),
      // `npm run test:deep`
      ...nodeProjects('deep', mode, DEEP_SET),
      // `npm run test:browser`: everything that needs Chromium or Firefox
      // its files are not isolated from one another: those that one worker runs share a Chromium
      {
        extends: true,
        test: {
          name: 'browser',
          include: [IN_BROWSERS],
          globalSetup: 'tests/e2e/profiles.ts',
          isolate: false,
          // a browser is several processes: more of them would only wait for each other
          maxWorkers: 2,
          sequence: { groupOrder: 1 },
        },
      },
    ],
    // a skipped test is loud on a developer's machine and an error in CI: see .ci/run
    reporters: ['default'],
    testTimeout: PATIENCE,
    hookTimeout: PATIENCE,
    // for two cores: tests that wait for a command or a server leave theirs to another
    maxWorkers: 3,
  },
}));
