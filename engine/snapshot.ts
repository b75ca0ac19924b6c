/**
 * Checks that a snapshot has the length of the state that it is to replace.
 * @throws {RangeError} if it has not
 */
export function expectSnapshot(snapshot: Float64Array, length: number): void {
  if (snapshot.length === length) return;
  throw new RangeError(`expected a snapshot of ${length} numbers of this scene, found ${snapshot.length}`);
}
