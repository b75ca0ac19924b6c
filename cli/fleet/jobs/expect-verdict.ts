/**
 * A record has the verdict that a thread gave, unless somebody has changed it since.
 * @throws Error if it is none
 */
export function expectVerdict(found: unknown, known: readonly unknown[]): void {
  if (!known.includes(found)) throw new Error(`expected a verdict, found ${JSON.stringify(found) ?? 'none'}`);
}
