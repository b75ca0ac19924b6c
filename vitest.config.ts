import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['tests/**/*.test.ts'],
    // a skipped test is loud on a developer's machine and an error in CI: see .ci/run
    reporters: ['default'],
    // ms: no test is about time; these end what hangs, also on a machine that is busy with something else
    testTimeout: 180_000,
    hookTimeout: 180_000,
    // two workers: more would only wait for each other on the machines this runs on
    maxWorkers: 2,
  },
});
