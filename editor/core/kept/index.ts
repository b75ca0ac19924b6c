/** What stays with an object as long as the object is in use: it is made when first asked for, and is the same from then on. */
export function keptWith<K extends object, V>(make: (owner: K) => V): (owner: K) => V {
  const kept = new WeakMap<K, V>();
  return (owner) => {
    let known = kept.get(owner);
    if (known === undefined) {
      known = make(owner);
      kept.set(owner, known);
    }
    return known;
  };
}

/** What stays with an open level as long as its document is in use, also while another level is open: made when first asked for. */
export function ofDocument<V>(make: () => V): (level: { readonly document: object }) => V {
  const at = keptWith<object, V>(make);
  return ({ document }) => at(document);
}
