import { mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { atMost, copiedLevels, define, inFolder, median, number, runGq, spread, text, writeLevels } from './harness/index.ts';

interface Checked {
  /** s of processor time */
  readonly seconds: number;
  readonly report: string;
}

/**
 * Checks the levels of a folder.
 * @throws {Error} unless every file was checked and each is completable
 */
function check(folder: string, files: number, ...options: string[]): Checked {
  const { stdout, processor } = runGq(folder, 'check', 'levels', '--jobs', '2', '--format', 'json', ...options);
  const { completable } = (JSON.parse(stdout) as { summary: Record<string, number> }).summary;
  if (completable !== files) throw new Error(`expected ${files} completable levels, found ${completable}`);
  return { seconds: processor, report: stdout };
}

const withoutTimes = (report: string): string => report.replace(/"ms":[\d.e-]+/g, '"ms":0');

const times = (count: number, work: (i: number) => number): number[] => Array.from({ length: count }, (_, i) => work(i));

export const bench = define({
  what: '3,600 unchanged level files through gq check, and what keeping their reports costs',
  options: {
    files: number(3600, 'files'),
    rounds: number(5, 'checks without a cache and checks that fill one, in turn'),
    levels: text('a folder of levels to copy instead of the shipped ones'),
  },
  claims: {
    warm: atMost(1, 'nothing changed, s'),
    changed: atMost(1.2, 'one file changed, s'),
    overhead: atMost(10, 'filling an empty cache over none, %'),
    different: atMost(0, 'reports that differ with and without a cache'),
  },
  run: ({ files, rounds, levels }) =>
    inFolder('cache', (folder) => {
      mkdirSync(join(folder, 'levels'));
      writeLevels(join(folder, 'levels'), copiedLevels(files, levels ?? undefined));
      const cache = join(folder, 'cache');
      const without: Checked[] = [];
      const filling: Checked[] = [];
      for (let round = 0; round < rounds; round++) {
        const turns = [
          () => without.push(check(folder, files, '--no-cache')),
          () => {
            rmSync(cache, { recursive: true, force: true });
            filling.push(check(folder, files, '--cache-dir', cache));
          },
        ];
        for (const turn of round % 2 === 0 ? turns : turns.reverse()) turn();
      }
      const first = filling[rounds - 1];
      const same = withoutTimes(first.report) === withoutTimes(without[0].report);
      const warm = times(3 * rounds, () => {
        const { seconds, report } = check(folder, files, '--cache-dir', cache);
        if (report !== first.report) throw new Error('expected the report that was kept, found another one');
        return seconds;
      });
      const bytes = readdirSync(cache).reduce((all, name) => all + statSync(join(cache, name)).size, 0);
      const changing = join(folder, 'levels', '0000.level.json');
      const before = readFileSync(changing, 'utf8');
      const changed = times(rounds, (i) => {
        writeFileSync(changing, `${before}${' '.repeat(i + 1)}`);
        return check(folder, files, '--cache-dir', cache).seconds;
      });
      const rows = [
        ['without a cache', without.map(({ seconds }) => seconds)],
        ['filling an empty cache', filling.map(({ seconds }) => seconds)],
        ['nothing changed', warm],
        ['one file changed', changed],
      ] as const;
      return {
        title: `gq check --jobs 2 on ${files} level files, a run each: processor time of all threads, process start and JSON report included`,
        columns: ['', 's', 'quartiles', 'checks'],
        rows: rows.map(([name, seconds]) => {
          const { median: middle, q1, q3 } = spread(seconds);
          return [name, middle, `${q1.toFixed(2)} - ${q3.toFixed(2)}`, seconds.length];
        }),
        measured: {
          warm: median(warm),
          changed: median(changed),
          overhead: median(filling.map(({ seconds }, i) => 100 * (seconds / without[i].seconds - 1))),
          different: same ? 0 : 1,
        },
        notes: [
          `The files are the shipped levels, each moved as a whole by some px. The cache takes ${(bytes / 1e6).toFixed(1)} MB. Medians.`,
        ],
      };
    }),
});
