/** Text in pieces that can be read as often as is wanted. */
export const inPieces = (make: () => Iterable<string>): Iterable<string> => ({
  [Symbol.iterator]: () => make()[Symbol.iterator](),
});

/**
 * A report as JSON in pieces, for any number of levels.
 * @param rest all keys but `version` and `levels`
 */
export function* jsonWithLevels<T>(levels: Iterable<T>, toJson: (level: T) => object, rest: object): Generator<string> {
  yield `{"version":1,"levels":[`;
  let comma = '';
  for (const level of levels) {
    yield comma + JSON.stringify(toJson(level));
    comma = ',';
  }
  const tail = JSON.stringify(rest).slice(1);
  yield tail === '}' ? ']}\n' : `],${tail}\n`;
}
