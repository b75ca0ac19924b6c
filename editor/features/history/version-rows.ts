import type { Version } from '../../core/versions/index.ts';

/** Labels in which those that follow each other and are equal are one: `Nudge ×3`. */
function runsOf(labels: readonly string[]): string[] {
  const runs: { label: string; count: number }[] = [];
  for (const label of labels) {
    const last = runs.at(-1);
    if (last?.label === label) last.count++;
    else runs.push({ label, count: 1 });
  }
  return runs.map(({ label, count }) => (count === 1 ? label : `${label} ×${count}`));
}

const UNLABELLED = {
  page: 'Saved',
  other: 'Changed by another program',
  found: 'Found when the level was opened',
} as const;

/** What led to a version: `Move asteroid 3, Add hold`. */
export function stepsInWords({ labels, more, by }: Pick<Version, 'labels' | 'more' | 'by'>): string {
  const shown = runsOf(labels);
  if (shown.length === 0) return UNLABELLED[by];
  return more === 0 ? shown.join(', ') : `${more} earlier ${more === 1 ? 'step' : 'steps'}, ${shown.join(', ')}`;
}

const WHO = {
  page: 'Saved by this editor.',
  other: 'Written by another program.',
  found: 'It was there when the level was opened, so who wrote it is not known.',
} as const;

/** Who made a version, as a sentence. */
export const whoInWords = ({ by }: Pick<Version, 'by'>): string => WHO[by];
