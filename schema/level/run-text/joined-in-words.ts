import type { Hold } from '../../basics/index.ts';

/** Something to say of a place in the text. */
interface Said {
  readonly at: number;
  readonly message: string;
}

/**
 * What becomes of holds that overlap, touch or are out of order.
 * @param places the offset of each hold in its text
 */
export function joinedInWords(holds: readonly Hold[], places: readonly number[]): Said[] {
  const said: Said[] = [];
  const late = holds.findIndex(([press], i) => i > 0 && press < holds[i - 1][0]);
  if (late >= 0) said.push({ at: places[late], message: 'the holds are put in order of time' });
  const sorted = [...holds.keys()].sort((a, b) => holds[a][0] - holds[b][0]);
  for (let i = 0; i < sorted.length; ) {
    const group = [sorted[i]];
    const [press] = holds[sorted[i]];
    let [, release] = holds[sorted[i]];
    for (i++; i < sorted.length && holds[sorted[i]][0] <= release; i++) {
      group.push(sorted[i]);
      release = Math.max(release, holds[sorted[i]][1]);
    }
    if (group.length === 1) continue;
    const what = group.length === 2 ? group.map((k) => holds[k].join('-')).join(' and ') : `${group.length} holds`;
    said.push({
      at: Math.max(...group.map((k) => places[k])),
      message: `${what} overlap or touch, and become ${press}-${release}`,
    });
  }
  return said;
}
