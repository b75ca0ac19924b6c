import { killWriterAt } from '../../tests/interrupted/killed-writer.ts';

/**
 * Kills a program that changes a folder of levels before each of its steps; the exit code becomes 1 when a file is not whole or lost.
 * @param from the first step
 * @param until ms since 1970; no step begins after that
 */
export async function attackWriters(from: number, most: number, until: number): Promise<void> {
  let bugs = 0;
  let step = from;
  for (; step < from + most && Date.now() < until; step++) {
    const { steps, wrong } = await killWriterAt(1 + step);
    if (wrong.length > 0) bugs++;
    for (const what of wrong) console.log(`bug  step ${1 + step}: ${what}`);
    if (steps !== null) break;
  }
  console.log(`\nwriters killed at steps ${1 + from} to ${step}, ${bugs} bugs`);
  if (bugs > 0 || step === from) process.exitCode = 1;
}
