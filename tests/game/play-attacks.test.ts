import { expect, it } from 'vitest';
import { isHunt } from '../depth.ts';
import { attack } from './mutated-plays.ts';

it('of mutated plays none is accepted that is not true, none throws and none takes long', () => {
  const { verdicts, failures, mostWork, acceptedOthers } = attack(isHunt ? 1_000_000 : 4000, isHunt ? 2 : 1);
  expect(failures).toEqual([]);
  expect(mostWork).toBeLessThanOrEqual(20_001);
  for (const verdict of ['claim-differs', 'stale-level', 'unknown-engine', 'malformed'] as const) {
    expect(verdicts[verdict]).toBeGreaterThan(50);
  }
  if (isHunt) console.log(JSON.stringify({ verdicts, acceptedOthers, mostWork }));
}, 3_600_000);
