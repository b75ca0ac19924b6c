import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Result } from 'axe-core';
import type { Page } from 'playwright-core';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** The rules that depend on the theme. */
export const COLOUR_RULES = ['color-contrast', 'link-in-text-block'];

/**
 * Violations of the rules for WCAG 2.2 AA, and of the rule for names, which axe runs only on request.
 * @param within a selector for a part of the page
 * @param rules only these; all by default
 */
export async function complaintsAbout(
  page: Page,
  where: string,
  within = 'html',
  rules: readonly string[] | null = null,
): Promise<string[]> {
  const violations = await page.evaluate(
    async ([source, selector, only]) => {
      // the page's content security policy forbids a script element
      if (!('axe' in window)) new Function(source).call(window);
      const { axe } = window as unknown as typeof window & { axe: typeof import('axe-core') };
      const { violations: found } = await axe.run(selector, {
        runOnly: only === null ? ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'] : { type: 'rule', values: [...only] },
        rules: only === null ? { 'label-content-name-mismatch': { enabled: true } } : {},
      });
      return found as Result[];
    },
    [AXE, within, rules] as const,
  );
  return violations.flatMap(({ id, nodes }) =>
    nodes
      // a hold and its edges are places in time: they can't be wider than the time that they stand for
      .filter(({ html }) => !(id === 'target-size' && /hold__(edge|body)/.test(html)))
      .map(({ html }) => `${where}: ${id}: ${html.slice(0, 200)}`),
  );
}
