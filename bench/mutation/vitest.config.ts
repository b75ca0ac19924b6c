import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { instrumented } from './instrument.ts';
import { allMutants } from './mutants.ts';
import { PLAN, type Plan } from './plan.ts';

const root = fileURLToPath(new URL('../..', import.meta.url));
const plan = JSON.parse(readFileSync(process.env[PLAN] as string, 'utf8')) as Plan;
const mutants = allMutants(root, plan.files);
const standIn = fileURLToPath(new URL('./vitest-stand-in.ts', import.meta.url));

export default defineConfig({
  root,
  plugins: [
    {
      name: 'mutants',
      enforce: 'pre',
      resolveId(id, importer) {
        const isTest = importer?.startsWith(`${root}tests/`);
        return id === 'vitest' && isTest ? standIn : null;
      },
      transform(code, id) {
        const file = id.split('?')[0].slice(root.length);
        const isSource = id.startsWith(root) && /^(schema|engine|solver|check|picture|review|cli|editor)\/.*\.ts$/.test(file);
        return isSource
          ? {
              code: instrumented(
                file,
                code,
                mutants.filter((mutant) => mutant.file === file),
              ),
              map: null,
            }
          : null;
      },
    },
  ],
  resolve: { alias: [{ find: /^fast-check$/, replacement: `${root}tests/fast-check.ts` }] },
  test: {
    include: ['bench/mutation/session.ts'],
    reporters: ['dot'],
    pool: 'forks',
    maxWorkers: 1,
    testTimeout: 0,
  },
});
