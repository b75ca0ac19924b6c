import { placeIn } from '../../../schema/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { openLinkedPlays } from '../../core/plays/index.ts';
import { playInFragment, playsInText } from '../../core/shelf/index.ts';

/** A play in the page's address. */
export interface LinkedPlay {
  readonly text: string;
  /** Whether the address has the content of a level, too, which the user is asked to add. */
  readonly hasLevel: boolean;
}

/** Takes the play out of the page's address, so that a reload does not open it again; null if there is none. */
export function takeLinkedPlay(page: Pick<Window, 'location' | 'history'>): LinkedPlay | null {
  const { hash } = page.location;
  const text = playInFragment(hash);
  if (text === null) return null;
  // A full URL: a path that begins with two slashes would otherwise name another host.
  const bare = new URL(page.location.href);
  bare.hash = hash
    .slice(1)
    .split('&')
    .filter((part) => !part.startsWith('play='))
    .join('&');
  page.history.replaceState(page.history.state, '', bare.href.replace(/#$/, ''));
  return { text, hasLevel: /(?:^#|&)level=/.test(hash) && placeIn(hash) === null };
}

/** Resolves when the user has been asked about the level of a link, and has answered. */
function answered({ incoming }: Editor): Promise<void> {
  return new Promise((resolve) => {
    let isAsked = incoming.getState() !== null;
    const stop = incoming.subscribe((file) => {
      if (file === null && isAsked) {
        stop();
        resolve();
      }
      isAsked ||= file !== null;
    });
  });
}

async function openLinked(editor: Editor, { text, hasLevel }: LinkedPlay): Promise<void> {
  const { plays, refused } = playsInText(text, 'the play of the link');
  await openLinkedPlays(editor, plays, { refused, answered: hasLevel ? () => answered(editor) : null });
}

/** Opens the play that the page's address named, and those of links that are followed while the page is open. */
export function followPlayLinks(editor: Editor, first: LinkedPlay | null): void {
  const open = (linked: LinkedPlay | null) => {
    if (linked !== null) void openLinked(editor, linked);
  };
  open(first);
  window.addEventListener('hashchange', () => open(takeLinkedPlay(window)));
}
