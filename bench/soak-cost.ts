import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { MAX_FILE_SIZE } from '../schema/index.ts';
import { optionValue } from './harness.ts';
import { randomHeavy } from './soak/random-heavy.ts';

/** What the check of a file may take: processor time in s, and peak memory in MiB. */
const MOST_SECONDS = 10;
const MOST_MEMORY = 512;

const GQ = fileURLToPath(new URL('../cli/main.js', import.meta.url));
const PROBE = `
  const { resourceUsage } = process;
  process.on('exit', () => {
    const { userCPUTime, systemCPUTime, maxRSS } = resourceUsage.call(process);
    process.stderr.write('\\nUSED ' + (userCPUTime + systemCPUTime) / 1e6 + ' ' + maxRSS / 1024 + '\\n');
  });
`;

interface Used {
  readonly verdict: string;
  /** Processor time, s, so that other work on the machine does not count. */
  readonly seconds: number;
  /** Peak memory, MiB. */
  readonly memory: number;
}

/** Checks a file with the built command, in a process of its own. */
function check(file: string, probe: string): Used {
  const child = spawnSync(process.execPath, ['--import', probe, GQ, 'check', '--jobs', '1', '--format', 'json', file], {
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
    timeout: 20 * MOST_SECONDS * 1000,
    killSignal: 'SIGKILL',
  });
  const used = /USED (\S+) (\S+)/.exec(child.stderr);
  if (used === null) return { verdict: 'killed', seconds: Number.POSITIVE_INFINITY, memory: Number.NaN };
  const report = JSON.parse(child.stdout) as { levels: { verdict: string }[] };
  return { verdict: report.levels[0].verdict, seconds: Number(used[1]), memory: Number(used[2]) };
}

const only = optionValue('--only');
const from = Number(only ?? optionValue('--from') ?? 0);
const levels = only === null ? Number(optionValue('--levels') ?? 1000) : 1;
const until = Date.now() + 1000 * Number(optionValue('--seconds') ?? 3600);
const folder = mkdtempSync(join(tmpdir(), 'gq-cost-'));
const probe = join(folder, 'probe.mjs');
writeFileSync(probe, PROBE);
const worst = { seconds: { value: 0, seed: -1 }, memory: { value: 0, seed: -1 } };
let finds = 0;
let done = 0;
try {
  for (let seed = from; seed < from + levels && Date.now() < until; seed++) {
    const file = join(folder, 'heavy.level.json');
    const text = JSON.stringify(randomHeavy(seed));
    // larger files are refused unread
    if (text.length > MAX_FILE_SIZE) continue;
    writeFileSync(file, text);
    const { verdict, seconds, memory } = check(file, probe);
    done++;
    if (seconds > worst.seconds.value) worst.seconds = { value: seconds, seed };
    if (memory > worst.memory.value) worst.memory = { value: memory, seed };
    const isBad = !(seconds <= MOST_SECONDS) || !(memory <= MOST_MEMORY) || verdict === 'crashed' || verdict === 'invalid';
    if (isBad) finds++;
    if (isBad || only !== null) console.log(`level ${seed}: ${verdict}, ${seconds.toFixed(1)} s, ${memory.toFixed(0)} MiB`);
  }
} finally {
  rmSync(folder, { recursive: true });
}
console.log(
  `${done} levels from ${from} on: ${finds} took more than ${MOST_SECONDS} s of processor time or ${MOST_MEMORY} MiB, or were no levels; ` +
    `longest ${worst.seconds.value.toFixed(1)} s (level ${worst.seconds.seed}), most memory ${worst.memory.value.toFixed(0)} MiB (level ${worst.memory.seed})`,
);
if (finds > 0 || done === 0) process.exitCode = 1;
