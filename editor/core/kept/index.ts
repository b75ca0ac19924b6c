/** What stays with an object as long as the object is in use: it is made when first asked for, and is the same from then on. */
export function keptWith<K extends object, V>(make: (owner: K) => V): (owner: K) => V {
  const kept = new WeakMap<K, V>();
  return (owner) => {
    const known = kept.get(owner) ?? make(owner);
    kept.set(owner, known);
    return known;
  };
}
