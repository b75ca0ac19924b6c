import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { atMost, define, inFolder, movedLevel, packFiles, sum, writeLevels } from './harness/index.ts';
import { commandRows, commandTime, timeCommand } from './timed-command.ts';

const LEVELS = 28;
const VALUES = 41;

export const bench = define({
  what: '28 levels at 41 values of a rule through gq tune',
  options: {},
  claims: { time: atMost(2, `${LEVELS} levels at ${VALUES} values with --jobs 2, s`) },
  run: () =>
    inFolder('tune', (folder) => {
      const shipped = packFiles();
      mkdirSync(join(folder, 'levels'));
      // repeated ones are moved by some px
      const levels = Array.from({ length: LEVELS }, (_, i) =>
        movedLevel(shipped[i % shipped.length].file, 64 * Math.floor(i / shipped.length), 0),
      );
      writeLevels(join(folder, 'levels'), levels);
      const args = ['tune', 'levels', '--sweep', `pull=0.8x..1.2x:${VALUES}`, '--jobs', '2', '--format', 'json'];
      const measured = timeCommand(folder, args, ({ stdout }) => {
        const replayed = sum(
          (JSON.parse(stdout) as { levels: { values: unknown[] }[] }).levels.map(({ values }) => values.length),
        );
        if (replayed !== LEVELS * VALUES) throw new Error(`expected ${LEVELS * VALUES} results, found ${replayed}`);
      });
      return {
        title: `gq tune on ${LEVELS} levels at ${VALUES} values of the pull, thresholds included`,
        columns: ['', 's', 'quartiles'],
        rows: commandRows(measured, 'gq tune --jobs 2'),
        measured: { time: commandTime(measured) },
        notes: [`Medians of ${measured.rounds} interleaved runs, process start and JSON report included.`],
      };
    }),
});
