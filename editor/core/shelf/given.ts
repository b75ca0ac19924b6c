import { PLAY_LIMITS, playFromText } from '../../../game/index.ts';

/** A play that a person opens. */
export interface GivenPlay {
  /** The name of its file, or what else it is: `the clipboard`. */
  readonly name: string;
  readonly bytes: Uint8Array;
}

/** A file that is no play, and why. */
export interface RefusedFile {
  readonly name: string;
  readonly reason: string;
}

/** How the name of a play's file ends. */
export const PLAY_EXTENSION = '.gqr';

export const isPlayFile = ({ name }: { readonly name: string }): boolean => name.toLowerCase().endsWith(PLAY_EXTENSION);

/** What to call a play after its file: `ann.gqr` becomes `ann`. */
export const bareTitle = (title: string): string => title.replace(/\.gqr$/i, '');

/** Base64url of the first three bytes of every play: 0x89, `G`, `Q`. */
const BEGINNING = 'iUdR';

const LINKED = /(?:^|[#&])play=([\w-]+)/;

/** The play in a fragment such as `#level=...&play=...`, as text; null if it has none. */
export const playInFragment = (fragment: string): string | null => LINKED.exec(fragment)?.[1] ?? null;

/** Whether a text is a play, or a link to one: then it is not meant to be anything else. */
export function isPlayText(text: string): boolean {
  const trimmed = text.trim();
  return trimmed.startsWith(BEGINNING) || (/^https?:\/\/\S+$/.test(trimmed) && playInFragment(trimmed) !== null);
}

/** The plays in a text: each is base64url on a line of its own, or a link. */
export function playsInText(text: string, name: string): { readonly plays: GivenPlay[]; readonly refused: RefusedFile[] } {
  const words = text.split(/\s+/).filter(Boolean);
  const plays: GivenPlay[] = [];
  const refused: RefusedFile[] = [];
  for (const [i, word] of words.entries()) {
    const called = words.length === 1 ? name : `${name}, part ${i + 1}`;
    const bytes = playFromText(playInFragment(word) ?? word);
    if (bytes === null) {
      const found = word.length > 24 ? `${word.slice(0, 24)}…` : word;
      refused.push({
        name: called,
        reason: `expected a play as base64url text, which begins with “${BEGINNING}”, or a link with “play=”; found “${found}”`,
      });
    } else plays.push({ name: called, bytes });
  }
  return { plays, refused };
}

/** Files that are read at the same time. */
const AT_ONCE = 32;

/** Reads files, a few at a time, so that thousands do not block the page. @param isOver asked between them: whether to stop */
export async function readPlayFiles(
  files: readonly File[],
  isOver: () => boolean = () => false,
): Promise<{ readonly plays: GivenPlay[]; readonly refused: RefusedFile[] }> {
  const plays: GivenPlay[] = [];
  const refused: RefusedFile[] = [];
  const read = async (file: File) => {
    const { size } = file;
    const name = file.webkitRelativePath || file.name;
    // what is too large for a play is not read
    if (size > PLAY_LIMITS.bytes) {
      refused.push({ name, reason: `expected a play of at most ${PLAY_LIMITS.bytes} bytes, found ${size}` });
      return;
    }
    try {
      plays.push({ name, bytes: new Uint8Array(await file.arrayBuffer()) });
    } catch {
      refused.push({ name, reason: 'the browser can’t read it: it was moved or deleted, or is not yours to read' });
    }
  };
  for (let i = 0; i < files.length && !isOver(); i += AT_ONCE) await Promise.all(files.slice(i, i + AT_ONCE).map(read));
  return { plays, refused };
}
