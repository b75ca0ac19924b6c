import type { Terms } from '../../../engine/index.ts';
import { levelFragment, levelTextOf } from '../../../phaser/links/index.ts';
import { formatLevel, type LevelFile, type Problem } from '../../../schema/index.ts';
import { readText } from '../files/index.ts';

/** A link, or why there is none. */
export type Linking =
  | { readonly ok: true; readonly url: string }
  | { readonly ok: false; readonly message: string; readonly hint: string };

type Linked =
  | { readonly ok: true; readonly file: LevelFile }
  | { readonly ok: false; readonly message: string; readonly problems: readonly Problem[] };

/** characters; mail and chat programs cut off longer links */
export const LONGEST_LINK = 8000;

/**
 * A link that contains a level in its fragment, which no server sees, and the terms under which it is to be played.
 * @param page URL of the page, without a fragment
 */
export async function linkTo(file: LevelFile, { accuracy, maxTime }: Terms, page: string): Promise<Linking> {
  // as one line the text is shorter, and it reads back the same
  const level = await levelFragment(JSON.stringify(JSON.parse(formatLevel(file))));
  const url = `${page}#${level}&accuracy=${accuracy.name}&max-time=${maxTime}`;
  if (url.length <= LONGEST_LINK) return { ok: true, url };
  const message = `the link would have ${url.length} characters, but mail and chat programs cut off links of more than ${LONGEST_LINK}`;
  return { ok: false, message, hint: 'download the level and send the file, or delete runs that are not needed' };
}

/** The level in a fragment such as `#level=...`; null if there is none. */
export async function levelOf(fragment: string): Promise<Linked | null> {
  const linked = await levelTextOf(fragment);
  if (linked === null) return null;
  if (!linked.ok) return { ...linked, problems: [] };
  const reading = readText(linked.text);
  if (reading.ok) return reading;
  return {
    ok: false,
    message: `the link contains no valid level: ${reading.problems[0].message}`,
    problems: reading.problems,
  };
}

/** The address of a published page, or why a text is none. */
type PlayPage = { readonly ok: true; readonly address: string } | { readonly ok: false; readonly message: string };

/** Reads the address of a published page as a person types or pastes it: without a fragment, and with `https://` if that is missing. */
export function playPageOf(typed: string): PlayPage {
  const text = typed.trim();
  const isLocal = /^(?:localhost|127\.0\.0\.1)(?::|\/|$)/i.test(text);
  const full = isLocal ? `http://${text}` : /^[a-z][a-z\d+.-]*:/i.test(text) ? text : `https://${text}`;
  if (!URL.canParse(full))
    return { ok: false, message: 'expected the address of the page, such as https://me.github.io/levels/' };
  const url = new URL(full);
  if (!['https:', 'http:', 'file:'].includes(url.protocol))
    return { ok: false, message: `expected an address that begins with https://, found ${url.protocol}` };
  url.hash = '';
  return { ok: true, address: url.href.replace(/#$/, '') };
}
