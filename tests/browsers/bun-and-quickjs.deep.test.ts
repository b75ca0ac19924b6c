import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { getQuickJS } from 'quickjs-emscripten';
import { beforeAll, describe, expect, it } from 'vitest';
import { ACCURACIES } from '../../engine/index.ts';
import { isHunt } from '../depth.ts';
import { declareMissing } from '../missing.ts';
import { bundleEngine } from './bundle.ts';
import { committedTable, type HashTable, questions } from './hash-table.ts';
import { hashedRuns } from './scenes.ts';

const committed = committedTable();
const runs = hashedRuns();

const BUN = join(dirname(createRequire(import.meta.url).resolve('bun/package.json')), 'bin', 'bun.exe');

const accuracies = Object.keys(ACCURACIES);
/** A hunt asks about each run at every accuracy. Otherwise the accuracies take turns. */
const isAsked = (accuracy: string, run: number): boolean => isHunt || accuracy === accuracies[run % accuracies.length];
const asked = runs.flatMap((run, i) => questions([run]).filter(([, , accuracy]) => isAsked(accuracy, i)));
const answersOf = (table: HashTable): string[] =>
  runs.flatMap(({ name }, i) => accuracies.filter((accuracy) => isAsked(accuracy, i)).map((accuracy) => table[name][accuracy]));

/** QuickJS interprets, some hundred times slower: it is asked about a part of each kind of run. */
const SHARE_OF_SCENES = 10;
const SHARE_OF_SHIPPED = isHunt ? 1 : 2;
const SHARE_OF_CASES = isHunt ? 1 : 7;
const forQuickJs = runs.filter(({ name }, i) => {
  if (name.startsWith('scene ')) return i % SHARE_OF_SCENES === 0;
  return i % (name.startsWith('hard: ') ? SHARE_OF_CASES : SHARE_OF_SHIPPED) === 0;
});

// in Node: tests/browsers/node.test.ts; in Chromium and Firefox: tests/e2e/hashes.test.ts
describe('hashes of runs', () => {
  let bundle = '';
  beforeAll(async () => {
    bundle = await bundleEngine();
  });

  if (existsSync(BUN)) {
    it('in Bun (the engine of Safari) are the committed ones, at accuracies in turn', () => {
      const folder = mkdtempSync(join(tmpdir(), 'gq-bun-'));
      try {
        writeFileSync(join(folder, 'questions.json'), JSON.stringify(asked));
        const ask = `;process.stdout.write(JSON.stringify(JSON.parse(require('fs').readFileSync('questions.json', 'utf8'))
          .map(([level, holds, accuracy]) => gravityQuest.hashOf(level, holds, accuracy))));`;
        writeFileSync(join(folder, 'run.cjs'), bundle + ask);
        const out = execFileSync(BUN, ['run.cjs'], { cwd: folder, encoding: 'utf8', maxBuffer: 1e8 });
        expect(JSON.parse(out)).toEqual(answersOf(committed));
      } finally {
        rmSync(folder, { recursive: true, force: true });
      }
    });
  } else {
    declareMissing('hashes in Bun', `no binary at ${BUN}: run npm ci`);
  }

  it('in QuickJS are the committed ones, of a part of the runs, at accuracies in turn', async () => {
    const context = (await getQuickJS()).newContext();
    try {
      context.unwrapResult(context.evalCode(bundle)).dispose();
      for (const [i, run] of forQuickJs.entries()) {
        for (const question of questions([run])) {
          const [, , accuracy] = question;
          if (!isAsked(accuracy, i)) continue;
          const call = `gravityQuest.hashOf(${question.map((text) => JSON.stringify(text)).join(', ')})`;
          const result = context.unwrapResult(context.evalCode(call));
          const answer = context.getString(result);
          result.dispose();
          expect([run.name, accuracy, answer]).toEqual([run.name, accuracy, committed[run.name][accuracy]]);
        }
      }
    } finally {
      context.dispose();
    }
  });
});
