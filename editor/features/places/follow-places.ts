import { type PlaceReading, placeIn } from '../../../schema/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { isOtherToken } from '../../core/files/index.ts';
import { showPlace } from './show-place.ts';

/** Removes the place from the page's address: a reload stays where the user has gone since. */
function forgetPlace(): void {
  // A full URL: a path that begins with two slashes would otherwise name another host.
  const bare = new URL(window.location.href);
  // a token stays there if the tab can't store it
  bare.hash = bare.hash
    .replace(/^#/, '')
    .split('&')
    .filter((part) => !/^(?:level|run|tick)=/.test(part))
    .join('&');
  window.history.replaceState(window.history.state, '', bare.href.replace(/#$/, ''));
}

/** Shows the place that the page's address names. @returns whether it names one whose level is there */
export async function takePlace(editor: Editor): Promise<boolean> {
  const reading: PlaceReading | null = placeIn(window.location.hash);
  if (reading === null) return false;
  forgetPlace();
  return showPlace(editor, reading);
}

/** Follows links to places that are typed or pasted into the address while the page is open. */
export function followPlaces(editor: Editor): void {
  const follow = () => {
    // the address that another start of gq edit has printed: only a new page can use its token
    if (isOtherToken(window)) window.location.reload();
    else void takePlace(editor);
  };
  window.addEventListener('hashchange', follow);
}
