import { closestName, type LevelEntry, type PlaceReading, placeIn } from '../../../schema/index.ts';
import { poseAt } from '../../canvas/index.ts';
import type { Editor, OpenLevel } from '../../core/context/index.ts';
import { allLevels, isOtherToken } from '../../core/files/index.ts';
import { openListed } from '../../core/levels/index.ts';
import { isWhole } from '../../core/proof/index.ts';
import type { Feature } from '../feature.ts';
import { levelsCalled, nearlyCalled } from './find-level.ts';

/** Links to a place of a level: a run, a tick. */
export const places: Feature = {
  name: 'places',
  openNamed(editor) {
    followPlaces(editor);
    return takePlace(editor);
  },
};

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
async function takePlace(editor: Editor): Promise<boolean> {
  const reading: PlaceReading | null = placeIn(window.location.hash);
  if (reading === null) return false;
  forgetPlace();
  return showPlace(editor, reading);
}

/** Follows links to places that are typed or pasted into the address while the page is open. */
function followPlaces(editor: Editor): void {
  const follow = () => {
    // the address that another start of gq edit has printed: only a new page can use its token
    if (isOtherToken(window)) window.location.reload();
    else void takePlace(editor);
  };
  window.addEventListener('hashchange', follow);
}

/** characters of a link that a notice repeats */
const LONGEST = 60;

/** A text from a link, in quotes: anybody can make a link, so what is in it is cut and can't change the direction of writing. */
function quoted(text: string): string {
  const plain = text.replace(/\p{C}/gu, '\u{fffd}');
  return plain.length > LONGEST ? `“${plain.slice(0, LONGEST)}…”` : `“${plain}”`;
}

/**
 * Opens the level that a link names, shows the run and the tick, and brings that place into view. What the link asks for and is
 * not there is reported as a notice.
 * @returns false if the level is not there
 */
async function showPlace(editor: Editor, { place, problem }: PlaceReading): Promise<boolean> {
  const { workspace, notices, open, session } = editor;
  const tell = (texts: readonly string[]) => {
    if (texts.length > 0) notices.show('warning', texts.join(' '), { topic: 'place' });
    else notices.clear('place');
  };
  let levels: readonly LevelEntry[] = workspace.store.getState().list?.levels ?? [];
  if (levelsCalled(levels, place.level).length === 0) levels = await allLevels(workspace);
  if (workspace.store.getState().list === null) return false;
  const [id, ...others] = levelsCalled(levels, place.level);
  if (id === undefined) {
    const near = nearlyCalled(levels, place.level);
    const hint = near === null ? 'Choose one in the list of levels.' : `Did you mean ${quoted(near)}?`;
    tell([`The link asks for the level ${quoted(place.level)}, which is not in this folder. ${hint}`]);
    return false;
  }
  session.setState({ mode: 'edit' });
  if (workspace.store.getState().opened?.id() !== id) await openListed(editor, id);
  const level = open.getState();
  // it is asked about first, it can't be read, or another one was opened in the meantime
  if (level === null || level.opened.id() !== id) return true;
  const said =
    others.length === 0 ? [] : [`${others.length + 1} levels are called ${quoted(place.level)}; this is ${quoted(id)}.`];
  said.push(...showRun(editor, level, place.run));
  if (problem !== null) said.push(`The link’s tick can’t be used: ${problem}.`);
  if (place.tick !== null) said.push(...showTick(editor, level, place.tick));
  tell(said);
  return true;
}

/** Shows a run of the open level. @returns what to tell the user */
function showRun({ session }: Editor, { document }: OpenLevel, wanted: string | null): string[] {
  const names = (document.file().runs ?? []).map(({ name }) => name);
  const isThere = wanted !== null && names.includes(wanted);
  session.setState({ run: isThere ? wanted : null, tick: 0, hoverTick: null, isPlayingBack: false });
  if (isThere || wanted === null) return [];
  if (names.length === 0) return [`The link asks for the run ${quoted(wanted)}, but this level has no run.`];
  const near = closestName(wanted, names);
  const hint = near === null ? `The first one, ${quoted(names[0])}, is shown.` : `Did you mean ${quoted(near)}?`;
  return [`The link asks for the run ${quoted(wanted)}, which this level does not have. ${hint}`];
}

/** Moves the playhead of the shown run to a tick and looks there. @returns what to tell the user */
function showTick({ session }: Editor, { proof }: OpenLevel, wanted: number): string[] {
  const now = proof.proof();
  const { run } = now;
  const last = Math.max(0, run.way.count - 1);
  const tick = Math.min(wanted, last);
  const { x, y } = poseAt(now, tick);
  session.setState({ tick, lookAt: { x, y } });
  // reports name the tick in which the run ends, which may begin after the last whole tick
  if (wanted <= Math.max(last, run.tick) + 1) return [];
  const of = run.name === null ? 'without a run, she' : `the run ${quoted(run.name)}`;
  const end = isWhole(now)
    ? `${of} ends at tick ${last}`
    : `${of} is simulated until tick ${last} only, since it takes much work`;
  return [`The link asks for tick ${wanted}, but ${end}.`];
}
