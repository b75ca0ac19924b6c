import { configDefaults, defineConfig } from 'vitest/config';
import { propertySettings } from './tests/property-settings.ts';

// ms: no test is about time; this ends what hangs, also on a machine that is busy with something else
const PATIENCE = 180_000 * Math.max(1, propertySettings(process.env).runs);

const IN_BROWSERS = 'tests/e2e/**/*.test.ts';

export default defineConfig({
  test: {
    projects: [
      // `npm test`: everything that needs no browser
      {
        extends: true,
        test: { name: 'node', include: ['tests/**/*.test.ts'], exclude: [...configDefaults.exclude, IN_BROWSERS] },
      },
      // `npm run test:browser`: everything that needs Chromium or Firefox
      // its files are not isolated from one another: those that one worker runs share a Chromium
      { extends: true, test: { name: 'browser', include: [IN_BROWSERS], globalSetup: 'tests/e2e/profiles.ts', isolate: false } },
    ],
    // a skipped test is loud on a developer's machine and an error in CI: see .ci/run
    reporters: ['default'],
    setupFiles: ['tests/property-seed.ts'],
    testTimeout: PATIENCE,
    hookTimeout: PATIENCE,
    // two workers: more would only wait for each other on the machines this runs on
    maxWorkers: 2,
  },
});
