/** `6.73 s`, or `1:06.73` */
export function timeText(seconds: number, digits = 2): string {
  if (seconds < 60) return `${seconds.toFixed(digits)} s`;
  const minutes = Math.floor(seconds / 60);
  return `${minutes}:${(seconds - 60 * minutes).toFixed(digits).padStart(digits === 0 ? 2 : digits + 3, '0')}`;
}

/** `3 stars`, `1 star` */
export const count = (number: number, one: string, several = `${one}s`): string => `${number} ${number === 1 ? one : several}`;

const KILLERS = { asteroid: 'a hot asteroid', nova: 'a nova', alien: 'an alien', blackHole: 'the black hole' } as const;

interface End {
  readonly outcome: string;
  readonly with: { readonly kind: keyof typeof KILLERS } | null;
}

/** How an attempt ended, as a sentence. */
export function endText({ outcome, with: object }: End): string {
  if (outcome === 'completed') return 'She reaches the black hole.';
  if (outcome === 'lost') return 'Lost in space.';
  if (outcome === 'timeout') return 'Out of time.';
  return object === null ? 'She is gone.' : `Collided with ${KILLERS[object.kind]}.`;
}

interface Raced {
  readonly name: string;
  readonly claim: { readonly tick: number; readonly outcome: string };
}

/** How a completed play compares with the one it raced. */
export function raceText(tick: number, { name, claim }: Raced): string {
  if (claim.outcome !== 'completed') return `${name} did not complete it`;
  const ahead = (claim.tick - tick) / 60;
  return ahead === 0 ? `As fast as ${name}` : `${timeText(Math.abs(ahead))} ${ahead > 0 ? 'ahead of' : 'behind'} ${name}`;
}
