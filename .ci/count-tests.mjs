import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';

// node .ci/count-tests.mjs REPORT...
// Says how many tests passed by vitest's own reports, one per project. Fails where a test failed or was skipped, where a
// report has no test, and where a test file of the folder `tests` is in no report because no project includes it.
let passed = 0;
const problems = [];
const reported = new Set();

for (const path of process.argv.slice(2)) {
  const report = JSON.parse(readFileSync(path, 'utf8'));
  let ofThis = 0;
  for (const file of report.testResults) {
    const name = relative('.', file.name);
    reported.add(name);
    for (const test of file.assertionResults) {
      if (test.status === 'passed') ofThis++;
      else problems.push(`${test.status === 'failed' ? 'failed' : `not run (${test.status})`}: ${name}: ${test.fullName}`);
    }
    if (file.status !== 'passed') problems.push(`${name}: ${file.status} ${file.message ?? ''}`);
  }
  if (ofThis === 0) problems.push(`${path}: no test passed`);
  if (report.success !== true) problems.push(`${path}: vitest reports a failure`);
  passed += ofThis;
}

for (const entry of readdirSync('tests', { recursive: true, withFileTypes: true })) {
  const path = join(entry.parentPath, entry.name);
  if (entry.isFile() && entry.name.endsWith('.test.ts') && !reported.has(path)) {
    problems.push(`${path}: in no report: no project of vitest.config.ts includes it`);
  }
}

for (const problem of problems) console.error(problem);
console.log(`${passed} passed, ${problems.length} ${problems.length === 1 ? 'problem' : 'problems'}`);
if (passed === 0 || problems.length > 0) process.exit(1);
