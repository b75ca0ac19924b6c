import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { MAX_FILE_SIZE } from '../../schema/index.ts';
import { checkBySteps } from '../../tests/judges/by-steps.ts';
import { checkGraze, GRAZED_AT, graze } from '../../tests/judges/contacts.ts';
import { randomHeavy } from '../../tests/scenes/random-heavy.ts';
import { steppableScene } from '../../tests/scenes/windy-scene.ts';
import { inFolder, tryGq } from '../harness/index.ts';
import { type Attacked, type Span, seedsOf } from './span.ts';

/** Checks that objects which she touches or misses by 1e-9 to 1 px are found or not, seed by seed. */
export function attackContacts(span: Span): Attacked {
  const counts = { hit: 0, missed: 0, vague: 0, bug: 0 };
  let last = span.from - 1;
  for (const seed of seedsOf(span)) {
    last = seed;
    for (const accuracy of GRAZED_AT) {
      const made = graze(seed, accuracy);
      if (made === null) continue;
      const finding = checkGraze(made);
      counts[finding.what]++;
      if (finding.what === 'bug') console.log(`bug  graze ${seed}: ${finding.why}`);
    }
  }
  return {
    tried: counts.hit,
    bugs: counts.bug,
    told: `seeds ${span.from} to ${last}: ${counts.hit} touches found, ${counts.missed} near misses left alone, ${counts.vague} that overlap at the start`,
  };
}

/** Checks that the engine agrees with another program that makes small steps, seed by seed. */
export function attackBySteps(span: Span): Attacked {
  const counts = { agrees: 0, vague: 0, bug: 0 };
  let [jumps, crossings, last] = [0, 0, span.from - 1];
  for (const seed of seedsOf(span)) {
    last = seed;
    const finding = checkBySteps(steppableScene(seed));
    counts[finding.what]++;
    if (finding.what === 'bug') console.log(`bug  steppable scene ${seed}: ${finding.why}`);
    if (finding.what !== 'agrees') continue;
    jumps += finding.jumps;
    crossings += finding.crossings;
  }
  return {
    tried: counts.agrees,
    bugs: counts.bug,
    told: `scenes ${span.from} to ${last}: ${counts.agrees} agree, with ${jumps} jumps and ${crossings} rims of winds crossed, ${counts.vague} about which small steps say nothing`,
  };
}

/** What the check of a file may take: processor time in s, so that other work on the machine does not count, and peak memory in MiB. */
const MOST_SECONDS = 10;
const MOST_MEMORY = 512;

/** Checks random valid files that are as expensive as possible with the built command, each in a process of its own. */
export const attackCost = (span: Span): Promise<Attacked> =>
  inFolder('cost', (folder) => {
    const longest = { value: 0, seed: -1 };
    const largest = { value: 0, seed: -1 };
    let [tried, bugs] = [0, 0];
    for (const seed of seedsOf(span)) {
      const text = JSON.stringify(randomHeavy(seed));
      // larger files are refused unread
      if (text.length > MAX_FILE_SIZE) continue;
      writeFileSync(join(folder, 'heavy.level.json'), text);
      const args = ['check', '--jobs', '1', '--format', 'json', 'heavy.level.json'];
      const { stdout, status, processor, memory } = tryGq(folder, args, 20 * MOST_SECONDS * 1000);
      const verdict = status === null ? 'killed' : (JSON.parse(stdout) as { levels: { verdict: string }[] }).levels[0].verdict;
      tried++;
      if (processor > longest.value) Object.assign(longest, { value: processor, seed });
      if (memory > largest.value) Object.assign(largest, { value: memory, seed });
      if (processor <= MOST_SECONDS && memory <= MOST_MEMORY && verdict !== 'crashed' && verdict !== 'invalid') continue;
      bugs++;
      console.log(`bug  level ${seed}: ${verdict}, ${processor.toFixed(1)} s, ${memory.toFixed(0)} MiB`);
    }
    return {
      tried,
      bugs,
      told:
        `${tried} files from ${span.from} on, of which none may take more than ${MOST_SECONDS} s of processor time or ${MOST_MEMORY} MiB: ` +
        `longest ${longest.value.toFixed(1)} s (level ${longest.seed}), most memory ${largest.value.toFixed(0)} MiB (level ${largest.seed})`,
    };
  });
