import { describe, expect, it } from 'vitest';

/**
 * Declares a suite whose requirements are missing: skipped with a reason on a developer's machine; a failure in CI, where
 * nothing may pass unchecked.
 */
export function declareMissing(suite: string, why: string): void {
  describe(suite, () => {
    if (process.env.CI) {
      it('has what it needs', () => expect.fail(why));
      return;
    }
    console.warn(`skipped: ${suite}: ${why}`);
    it.skip(why, () => {});
  });
}
