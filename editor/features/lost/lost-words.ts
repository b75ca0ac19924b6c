import type { LostFindings } from './lost-store.ts';

const plural = (count: number, what: string): string => `${count} ${what}${count === 1 ? '' : 's'}`;

/** How many lost states after which she lives on are known, apart: proved, and from which no run was found. */
export function countLost({ losing }: Pick<LostFindings, 'losing'>): { readonly proved: number; readonly notFound: number } {
  const states = losing?.states ?? [];
  const proved = states.filter(({ known }) => known === 'proved').length;
  return { proved, notFound: states.length - proved };
}

/** What is known, as one or two sentences. What is proved and what was only not found are never added up. */
export function lostInWords(findings: LostFindings): string {
  const { phase, losing, message } = findings;
  if (phase === 'off') return '';
  if (phase === 'waiting') return 'Waits until the level is at rest.';
  if (phase === 'needs a run') return 'No run completes the level yet, so nothing is known to be lost. Solve may find one.';
  if (phase === 'failed') return `Failed: ${message}. Hide and show the lost states to try again.`;
  if (phase === 'examining') return 'Examining where the level is already lost…';
  if (losing === null) return 'Stopped before anything was found.';
  const { proved, notFound } = countLost(findings);
  const { examined, open } = losing.counts;
  const lost =
    proved + notFound === 0
      ? 'none is known to be lost while she lives on'
      : `${proved} are proved lost although she lives on; from ${notFound} no run was found, which proves nothing`;
  return `${phase === 'stopped' ? 'Stopped. ' : ''}Of ${plural(examined, 'state')} ${open} can still reach the black hole, ${lost}.`;
}
