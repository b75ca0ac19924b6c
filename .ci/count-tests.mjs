import { readFileSync } from 'node:fs';

// Says how many tests passed by vitest's own report; fails where one failed or was skipped, or where none ran.
const report = JSON.parse(readFileSync(process.argv[2], 'utf8'));
const tests = report.testResults.flatMap((file) => file.assertionResults.map((test) => ({ file: file.name, ...test })));
const counts = { passed: 0, failed: 0 };
let notRun = 0;
for (const test of tests) {
  if (test.status in counts) counts[test.status]++;
  else {
    notRun++;
    console.error(`not run (${test.status}): ${test.file}: ${test.fullName}`);
  }
}
const brokenFiles = report.testResults.filter((file) => file.status !== 'passed');
for (const file of brokenFiles) console.error(`${file.name}: ${file.status} ${file.message ?? ''}`);
console.log(`${counts.passed} passed, ${counts.failed} failed${notRun > 0 ? `, ${notRun} not run` : ''}`);
if (counts.passed === 0 || counts.failed > 0 || notRun > 0 || brokenFiles.length > 0 || report.success !== true) process.exit(1);
