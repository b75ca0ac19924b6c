import { defineConfig } from 'vitest/config';
import { propertySettings } from './tests/property-settings.ts';

// ms: no test is about time; this ends what hangs, also on a machine that is busy with something else
const PATIENCE = 180_000 * Math.max(1, propertySettings(process.env).runs);

export default defineConfig({
  test: {
    include: ['tests/**/*.test.ts'],
    // a skipped test is loud on a developer's machine and an error in CI: see .ci/run
    reporters: ['default'],
    setupFiles: ['tests/property-seed.ts'],
    testTimeout: PATIENCE,
    hookTimeout: PATIENCE,
    // two workers: more would only wait for each other on the machines this runs on
    maxWorkers: 2,
  },
});
