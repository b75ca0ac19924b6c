import { appendFileSync, readFileSync } from 'node:fs';
import { expect, it, vi } from 'vitest';
import { type Fate, PLAN, type Plan, type Reach, type Result, type TestReach } from './plan.ts';
import { Board, Endless } from './switches.ts';
import { collect, countTests, runTests } from './test-tree.ts';

// A session runs in one process of vitest. For each mutant it loads the test files again, switches the mutant on, and runs the
// tests that reach it.

const plan = JSON.parse(readFileSync(process.env[PLAN] as string, 'utf8')) as Plan;
const board = new Board();
Object.assign(globalThis, { mutation: board });

const say = (result: Result): void => appendFileSync(plan.results, `${JSON.stringify(result)}\n`);

let loads = 0;
let mocked: readonly string[] = [];

/**
 * Loads a test file. What a file mocks stays mocked for all modules that are loaded later, and does not affect modules that are
 * loaded already. So a file with mocks, and the file after it, get modules of their own.
 */
function load(file: string) {
  // names of packages only: a path would be resolved relative to this file
  const mocks = [...readFileSync(file, 'utf8').matchAll(/\bvi\.mock\('([^']+)'/g)].map((match) => match[1]);
  if (mocks.length > 0 || mocked.length > 0) {
    for (const name of mocked) vi.doUnmock(name);
    vi.resetModules();
  }
  mocked = mocks;
  return collect(() => import(/* @vite-ignore */ `../../${file}?load=${loads++}`));
}

/** The time that a test may take, ms: much more than without a mutant. */
const patience = (ms: number): number => 3000 + 10 * ms;

async function within(ms: number, run: () => Promise<void>): Promise<void> {
  let timer: NodeJS.Timeout | undefined;
  const late = new Promise<never>((_, reject) => {
    timer = setTimeout(() => reject(new Endless()), ms);
  });
  board.allow(ms);
  try {
    await Promise.race([run(), late]);
  } finally {
    clearTimeout(timer);
  }
}

async function measure(): Promise<Reach> {
  const tests: TestReach[] = [];
  board.cover(true);
  for (const file of plan.tests) {
    board.takeReached();
    const began = performance.now();
    const root = await load(file);
    tests.push({ file, test: -1, ms: performance.now() - began, reached: board.takeReached(), fails: false });
    for (let n = 0; n < countTests(root); n++) {
      const start = performance.now();
      const failure = await runTests(
        root,
        (test) => test === n,
        (_, run) => run(),
      );
      if (failure !== null) console.error(`${file}, test ${n}, without a mutant: ${failure.error}`);
      tests.push({ file, test: n, ms: performance.now() - start, reached: board.takeReached(), fails: failure !== null });
    }
  }
  board.cover(false);
  return { tests };
}

async function attempt(id: number, isStatic: boolean, reach: Reach): Promise<[Fate, string]> {
  let isReached = false;
  for (const file of plan.tests) {
    const ofFile = reach.tests.filter((test) => test.file === file);
    const reaches = (test: TestReach) => isStatic || test.reached.includes(id);
    const atLoad = ofFile.find(({ test }) => test < 0) as TestReach;
    const wanted = new Map(
      ofFile
        .filter((test) => test.test >= 0 && !test.fails && (reaches(atLoad) || reaches(test)))
        .map((test) => [test.test, test]),
    );
    if (wanted.size === 0) continue;
    isReached = true;
    board.put(id);
    try {
      if (isStatic) vi.resetModules();
      board.allow(patience(atLoad.ms));
      const root = await load(file);
      const failure = await runTests(
        root,
        (test) => wanted.has(test),
        (test, run) => within(patience(wanted.get(test)?.ms ?? 0), run),
      );
      if (failure !== null)
        return [failure.error instanceof Endless || board.isLate ? 'timeout' : 'killed', `${file} ${failure.test}`];
    } catch (error) {
      return [error instanceof Endless ? 'timeout' : 'killed', `${file} as it is loaded`];
    } finally {
      board.put(0);
      if (isStatic) vi.resetModules();
    }
  }
  return [isReached ? 'survived' : 'unreached', ''];
}

it('tries what the plan says', async () => {
  if (plan.mutants === null) {
    say({ kind: 'reach', reach: await measure() });
    return;
  }
  const reach = plan.reach as Reach;
  for (const { id, isStatic } of plan.mutants) {
    say({ kind: 'begun', id });
    const [fate, by] = await attempt(id, isStatic, reach);
    say({ kind: 'tried', id, fate, by });
  }
  expect(plan.mutants.length).toBeGreaterThan(0);
}, 0);
