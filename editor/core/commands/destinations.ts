/** A level, run, object or rule that the palette can go to. */
export interface Destination {
  /** unique */
  readonly key: string;
  readonly group: 'Level' | 'Run' | 'Object' | 'Rule';
  readonly title: string;
  /** Distinguishes it from others of the same name. */
  readonly detail: string;
  readonly go: () => void;
}

/** At most this many of a list are offered; another typed letter narrows it. */
const MOST = 12;

/** Destinations that contain every word of the query; none while the query is empty. @param lists is read if there is a query */
export function findDestinations(lists: () => readonly (readonly Destination[])[], query: string): readonly Destination[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const isFound = ({ group, title, detail }: Destination) => {
    const text = `${group} ${title} ${detail}`.toLowerCase();
    return words.every((word) => text.includes(word));
  };
  return lists().flatMap((list) => list.filter(isFound).slice(0, MOST));
}
