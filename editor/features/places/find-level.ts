import { closestName, type LevelEntry } from '../../../schema/index.ts';

type Listed = Pick<LevelEntry, 'id' | 'name'>;

const SUFFIX = '.level.json';

/** What a person may call a level, in the form of an id: with slashes, without `./` and `.level.json`. */
function asId(asked: string): string {
  const parts = asked.split(/[\\/]+/).filter((part) => part !== '' && part !== '.');
  const path = parts.join('/');
  return path.endsWith(SUFFIX) ? path.slice(0, -SUFFIX.length) : path;
}

/** The ids that a path names: `levels/07` is `07` in the folder `levels`, and `levels/07` in the folder above. */
function byPath(levels: readonly Listed[], path: string): string[] {
  for (let rest = path; rest !== ''; rest = rest.slice(rest.indexOf('/') + 1)) {
    const exact = levels.filter(({ id }) => id === rest);
    if (exact.length > 0) return exact.map(({ id }) => id);
    if (!rest.includes('/')) break;
  }
  // the folder of the page may be above that of the link
  return levels.filter(({ id }) => id.endsWith(`/${path}`)).map(({ id }) => id);
}

/** The ids of the levels that a link can mean by a file, an id or a name; the likeliest first. */
export function levelsCalled(levels: readonly Listed[], asked: string): readonly string[] {
  const path = asId(asked);
  const found = path === '' ? [] : byPath(levels, path);
  if (found.length > 0) return found;
  const named = levels.filter(({ name }) => name === asked);
  if (named.length > 0) return named.map(({ id }) => id);
  const plain = (text: string): string => text.toLowerCase();
  const like = levels.filter(({ id, name }) => plain(id) === plain(path) || (name !== null && plain(name) === plain(asked)));
  return like.map(({ id }) => id);
}

/** The id of a level that is nearly called like this; null if there is none. */
export function nearlyCalled(levels: readonly Listed[], asked: string): string | null {
  const path = asId(asked);
  const stems = levels.map(({ id }) => id.slice(id.lastIndexOf('/') + 1));
  const stem = closestName(path.slice(path.lastIndexOf('/') + 1), stems);
  if (stem !== null) return levels[stems.indexOf(stem)].id;
  const names = levels.map(({ name }) => name ?? '');
  const name = closestName(asked, names);
  return name === null ? null : levels[names.indexOf(name)].id;
}
