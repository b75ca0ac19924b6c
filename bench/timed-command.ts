import { spawnSync } from 'node:child_process';
import process from 'node:process';
import { type Comparison, compare, type Ended, runGq, timeCells } from './harness/index.ts';

/** Times a command of gq in a folder side by side with the start of bare Node. `verify` looks at what it printed. */
export function timeCommand(folder: string, args: readonly string[], verify: (printed: Ended) => void): Comparison {
  return compare(
    [
      { name: 'node -e 0', run: () => spawnSync(process.execPath, ['-e', '0']).pid },
      {
        name: 'gq',
        run() {
          const ended = runGq(folder, ...args);
          verify(ended);
          return ended.stdout.length;
        },
      },
    ],
    { rounds: 15, sampleMs: 0, warmUpMs: 0 },
  );
}

/** s of both, as rows of a table. */
export const commandRows = (measured: Comparison, name: string): [string, number, string][] => {
  const [, ...cells] = timeCells(measured, 'gq', 2, 1000);
  return [timeCells(measured, 'node -e 0', 2, 1000), [name, ...cells]];
};

/** s of the command. */
export const commandTime = (measured: Comparison): number => measured.time('gq').median / 1000;
