import { Failure } from '../io/index.ts';

/**
 * Whole numbers in the notation of job arrays, sorted and each once: `2,5-7`. Three or more in a row become a range, as in
 * the status of a Job of Kubernetes. Without numbers it is empty.
 */
export function rangesOf(numbers: Iterable<number>): string {
  const sorted = [...new Set(numbers)].sort((a, b) => a - b);
  const parts: string[] = [];
  for (let i = 0; i < sorted.length; ) {
    const first = i;
    while (i + 1 < sorted.length && sorted[i + 1] === sorted[i] + 1) i++;
    const row = sorted.slice(first, ++i);
    if (row.length < 3) parts.push(...row.map(String));
    else parts.push(`${row[0]}-${row.at(-1)}`);
  }
  return parts.join(',');
}

/**
 * The numbers that `2,5-7` stands for, sorted and each once.
 * @param source what has the text, for messages
 * @param total the numbers are less than this
 * @throws Failure if the text is not of this form
 */
export function readRanges(text: string, source: string, total: number): number[] {
  const found = new Set<number>();
  for (const part of text.split(',')) {
    const match = /^(\d+)(?:-(\d+))?$/.exec(part);
    if (match === null)
      throw new Failure(`${source} ${JSON.stringify(text)}: expected shards, as in 2,5-7, found ${JSON.stringify(part)}`);
    const first = Number(match[1]);
    const last = Number(match[2] ?? match[1]);
    if (last < first) throw new Failure(`${source} ${text}: ${part} goes down: expected ${last}-${first}`);
    if (last >= total) {
      throw new Failure(
        `${source} ${text}: found no shard ${last}: the plan has ${total}, counted from 0; expected at most ${total - 1}`,
      );
    }
    for (let number = first; number <= last; number++) found.add(number);
  }
  return [...found].sort((a, b) => a - b);
}
