import { fileURLToPath } from 'node:url';
import { configDefaults, defineConfig } from 'vitest/config';
import { BUILT_FILES, builtRooms } from './tests/built-rooms.ts';
import { propertySettings } from './tests/property-settings.ts';

// ms: no test is about time; this ends what hangs, also on a machine that is busy with something else
const PATIENCE = 180_000 * Math.max(1, propertySettings(process.env).runs);

const IN_BROWSERS = 'tests/e2e/**/*.test.ts';
const NODE = ['tests/**/*.test.ts'];
const NO_NODE = [...configDefaults.exclude, IN_BROWSERS];
// They replace modules of Node. `vi.mock` reaches only what is loaded after it, so that each needs modules of its own.
const MOCKING = ['disk', 'full-disk', 'locks', 'other-systems', 'refusals', 'watch'].map(
  (name) => `tests/server/${name}.test.ts`,
);
// What a function allocates depends on the types that V8 has seen in it: other tests would show it more than a game does.
const ALONE = [...MOCKING, 'tests/phaser/allocation.test.ts'];

export default defineConfig(({ mode }) => ({
  // properties get one seed for all, see there
  resolve: { alias: [{ find: /^fast-check$/, replacement: fileURLToPath(new URL('tests/fast-check.ts', import.meta.url)) }] },
  test: {
    projects: [
      // `npm test`: everything that needs no browser. The files of a worker share modules, so that those are loaded once.
      {
        extends: true,
        plugins: mode === 'built' ? [builtRooms(import.meta.dirname)] : [],
        test: {
          name: 'node',
          include: NODE,
          exclude: [...NO_NODE, ...ALONE],
          isolate: false,
          server: { deps: { external: mode === 'built' ? [BUILT_FILES] : [] } },
        },
      },
      { extends: true, test: { name: 'node-alone', include: ALONE, exclude: NO_NODE } },
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
