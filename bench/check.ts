import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { DEFAULT_ACCURACY } from '../engine/index.ts';
import { accuracy, atMost, copiedLevels, define, inFolder, text, writeLevels } from './harness/index.ts';
import { commandRows, commandTime, timeCommand } from './timed-command.ts';

const FILES = 1000;

export const bench = define({
  what: '1,000 level files through gq check',
  options: { levels: text('a folder of levels to copy instead of the shipped ones'), accuracy: accuracy(DEFAULT_ACCURACY) },
  claims: { time: atMost(4, `${FILES} files with --jobs 2, s`) },
  run: (asked) =>
    inFolder('check', (folder) => {
      mkdirSync(join(folder, 'levels'));
      writeLevels(join(folder, 'levels'), copiedLevels(FILES, asked.levels ?? undefined));
      const options = ['--no-cache', '--jobs', '2', '--accuracy', asked.accuracy, '--format', 'json'];
      const measured = timeCommand(folder, ['check', 'levels', ...options], ({ stdout }) => {
        const { summary } = JSON.parse(stdout) as { summary: Record<string, number> };
        if (summary.completable !== FILES)
          throw new Error(`expected ${FILES} completable levels, found ${JSON.stringify(summary)}`);
      });
      const [bare, check] = commandRows(measured, 'gq check --jobs 2');
      return {
        title: `gq check on ${FILES} level files, a run each under ${asked.accuracy}, process start and JSON report included`,
        columns: ['', 's', 'quartiles', 'levels a second'],
        rows: [
          [...bare, null],
          [...check, FILES / commandTime(measured)],
        ],
        measured: { time: commandTime(measured) },
        notes: [
          `Medians of ${measured.rounds} interleaved checks. The files are the shipped levels, each moved as a whole by some px.`,
        ],
      };
    }),
});
