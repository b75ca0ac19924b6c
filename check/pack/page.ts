/** The file of a pack beside the page that plays it. */
export const PACK_FILE = 'pack.js';

/** Nothing comes from other hosts, and no script but the page's own files runs. */
const POLICY = [
  "default-src 'none'",
  "script-src 'self'",
  // the game sets styles of its own elements
  "style-src 'self' 'unsafe-inline'",
  "img-src 'self' data: blob:",
  "media-src 'self' data: blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/**
 * The page of the game, for one pack: with its title, and with the pack loaded before the game.
 * @param page the page that was built from the game
 * @param policy the Content-Security-Policy of the page
 * @throws if it is not such a page
 */
export function pageOf(page: string, title: string, policy: string = POLICY): string {
  const parts: readonly [what: string, pattern: RegExp, text: string][] = [
    ['a title', /<title>[^<]*<\/title>/, `<title>${escaped(title)}</title>`],
    [
      'its character set',
      /<meta charset="utf-8"\s*\/?>/i,
      `<meta charset="utf-8">\n    <meta http-equiv="Content-Security-Policy" content="${escaped(policy)}">`,
    ],
    ['a script', /(?=<script\b)/, `<script src="./${PACK_FILE}"></script>\n    `],
  ];
  const bare = page
    .replace(/<meta http-equiv="Content-Security-Policy"[^>]*>\s*/i, '')
    .replace(/<script\b[^>]*src="(?:\.\/)?pack\.js"[^>]*><\/script>\s*/i, '');
  return parts.reduce((text, [what, pattern, replacement]) => {
    if (!pattern.test(text)) throw new Error(`the page of the game is not as expected: it lacks ${what}`);
    return text.replace(pattern, () => replacement);
  }, bare);
}
