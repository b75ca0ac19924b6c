import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, beforeEach, expect, it } from 'vitest';

// .ci/count-tests.mjs decides in CI whether all tests were run

const SCRIPT = join(import.meta.dirname, '..', '.ci', 'count-tests.mjs');

let folder = '';
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'gq-count-'));
  for (const path of ['a.test.ts', 'e2e/b.test.ts']) {
    mkdirSync(dirname(join(folder, 'tests', path)), { recursive: true });
    writeFileSync(join(folder, 'tests', path), '');
  }
});
afterEach(() => rmSync(folder, { recursive: true, force: true }));

interface Reported {
  readonly success?: boolean;
  /** The state of each test, by file. */
  readonly tests: Readonly<Record<string, readonly string[]>>;
}

/** Counts the tests of two reports in the format of vitest. */
function count(...reports: readonly Reported[]): { status: number | null; stdout: string; stderr: string } {
  const paths = reports.map(({ success = true, tests }, i) => {
    const testResults = Object.entries(tests).map(([path, statuses]) => ({
      name: join(folder, 'tests', path),
      status: statuses.includes('failed') ? 'failed' : 'passed',
      assertionResults: statuses.map((status, k) => ({ status, fullName: `test ${k}` })),
    }));
    writeFileSync(join(folder, `${i}.json`), JSON.stringify({ success, testResults }));
    return `${i}.json`;
  });
  const { status, stdout, stderr } = spawnSync(process.execPath, [SCRIPT, ...paths], { cwd: folder, encoding: 'utf8' });
  return { status, stdout, stderr };
}

const node = { tests: { 'a.test.ts': ['passed', 'passed'] } };
const browser = { tests: { 'e2e/b.test.ts': ['passed'] } };

it('adds up the reports', () => {
  expect(count(node, browser)).toEqual({ status: 0, stdout: '3 passed, 0 problems\n', stderr: '' });
});

it('fails if a test failed or was skipped, if a report is empty, and if vitest failed for another reason', () => {
  expect(count(node, { success: false, tests: { 'e2e/b.test.ts': ['failed'] } })).toMatchObject({
    status: 1,
    stderr: expect.stringContaining('failed: tests/e2e/b.test.ts: test 0'),
  });
  expect(count(node, { tests: { 'e2e/b.test.ts': ['passed', 'pending'] } })).toMatchObject({
    status: 1,
    stderr: expect.stringContaining('not run (pending): tests/e2e/b.test.ts: test 1'),
  });
  expect(count(node, { tests: {} })).toMatchObject({ status: 1, stderr: expect.stringContaining('1.json: no test passed') });
  expect(count(node, { ...browser, success: false })).toMatchObject({ status: 1 });
});

it('fails if a test file is in no report', () => {
  writeFileSync(join(folder, 'tests', 'forgotten.test.ts'), '');
  expect(count(node, browser)).toMatchObject({
    status: 1,
    stderr: expect.stringContaining('tests/forgotten.test.ts: in no report'),
  });
});
