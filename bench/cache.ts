import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { writeCopies } from './copied-levels.ts';
import { atMost, optionValue, publish, spread } from './harness.ts';

const GQ = fileURLToPath(new URL('../cli/main.js', import.meta.url));
const FILES = Number(optionValue('--files') ?? 3600);
/** Checks without a cache and checks that fill one, in turn. */
const COLD_ROUNDS = Number(optionValue('--rounds') ?? 5);
const WARM_ROUNDS = 3 * COLD_ROUNDS;

/** Loaded before gq: says at its end how much processor time all its threads took, in microseconds. */
const TELL = `data:text/javascript,${encodeURIComponent(
  `import { writeSync } from 'node:fs';
  import { isMainThread } from 'node:worker_threads';
  if (isMainThread) process.on('exit', () => { const { user, system } = process.cpuUsage(); writeSync(3, String(user + system)); });`,
)}`;

interface Checked {
  /** s of processor time */
  readonly seconds: number;
  readonly report: string;
}

/** @throws {Error} unless every file was checked and each is completable */
function check(directory: string, ...options: string[]): Checked {
  const { stdout, stderr, status, output } = spawnSync(
    process.execPath,
    ['--import', TELL, GQ, 'check', join(directory, 'levels'), '--jobs', '2', '--format', 'json', ...options],
    { encoding: 'utf8', maxBuffer: 2 ** 30, stdio: ['ignore', 'pipe', 'pipe', 'pipe'] },
  );
  if (status !== 0) throw new Error(`expected gq check to exit with 0, it exited with ${status}: ${stderr.slice(0, 2000)}`);
  const { completable } = (JSON.parse(stdout) as { summary: Record<string, number> }).summary;
  if (completable !== FILES) throw new Error(`expected ${FILES} completable levels, found ${completable}`);
  return { seconds: Number(output[3]) / 1e6, report: stdout };
}

const withoutTimes = (report: string): string => report.replace(/"ms":[\d.e-]+/g, '"ms":0');

const times = (count: number, work: (i: number) => number): number[] => Array.from({ length: count }, (_, i) => work(i));

const directory = mkdtempSync(join(tmpdir(), 'gq-bench-cache-'));
try {
  mkdirSync(join(directory, 'levels'));
  writeCopies(join(directory, 'levels'), FILES);
  const cache = join(directory, 'cache');
  const without: Checked[] = [];
  const filling: Checked[] = [];
  for (let round = 0; round < COLD_ROUNDS; round++) {
    const turns = [
      () => without.push(check(directory, '--no-cache')),
      () => {
        rmSync(cache, { recursive: true, force: true });
        filling.push(check(directory, '--cache-dir', cache));
      },
    ];
    for (const turn of round % 2 === 0 ? turns : turns.reverse()) turn();
  }
  const first = filling[COLD_ROUNDS - 1];
  const same = withoutTimes(first.report) === withoutTimes(without[0].report);
  const warm = times(WARM_ROUNDS, () => {
    const { seconds, report } = check(directory, '--cache-dir', cache);
    if (report !== first.report) throw new Error('expected the report that was kept, found another one');
    return seconds;
  });
  const bytes = readdirSync(cache).reduce((sum, name) => sum + statSync(join(cache, name)).size, 0);
  const changing = join(directory, 'levels', '0000.level.json');
  const text = readFileSync(changing, 'utf8');
  const changed = times(COLD_ROUNDS, (i) => {
    writeFileSync(changing, `${text}${' '.repeat(i + 1)}`);
    return check(directory, '--cache-dir', cache).seconds;
  });

  const rows = [
    ['without a cache', without.map(({ seconds }) => seconds)],
    ['filling an empty cache', filling.map(({ seconds }) => seconds)],
    ['nothing changed', warm],
    ['one file changed', changed],
  ] as const;
  const overhead = spread(filling.map(({ seconds }, i) => 100 * (seconds / without[i].seconds - 1))).median;
  publish({
    title: `gq check --jobs 2 on ${FILES} level files, a run each: processor time of all threads, process start and JSON report included`,
    columns: ['', 's', 'quartiles', 'checks'],
    rows: rows.map(([name, seconds]) => {
      const { median, q1, q3 } = spread(seconds);
      return [name, median, `${q1.toFixed(2)} - ${q3.toFixed(2)}`, seconds.length];
    }),
    claims: [
      atMost('nothing changed, s', spread(warm).median, 1),
      atMost('one file changed, s', spread(changed).median, 1.2),
      atMost('filling an empty cache over none, %', overhead, 10),
      atMost('reports that differ with and without a cache', same ? 0 : 1, 0),
    ],
    notes: [
      `The files are the shipped levels, each moved as a whole by some px. The cache takes ${(bytes / 1e6).toFixed(1)} MB. Medians.`,
    ],
  });
} finally {
  rmSync(directory, { recursive: true, force: true });
}
