import type { Results } from '../../workers/index.ts';

/** Both versions in one picture, and what is true of each. @param drawn null while it is made; a text if it can't be made */
export function ComparisonPicture({ drawn }: { readonly drawn: Results['compare'] | string | null }) {
  if (drawn === null) return <p className="history__empty">Drawing both versions…</p>;
  if (typeof drawn === 'string') return <p className="history__empty">The picture can't be made: {drawn}</p>;
  const { svg, before, after, effects } = drawn;
  return (
    <>
      <dl className="history__standings">
        <dt>Before</dt>
        <dd>{before}</dd>
        <dt>After</dt>
        <dd>{after}</dd>
        {effects.length > 0 && (
          <>
            <dt>Effect</dt>
            <dd>{effects.join(', ')}</dd>
          </>
        )}
      </dl>
      {svg !== null && (
        <img
          className="history__picture"
          src={`data:image/svg+xml,${encodeURIComponent(svg)}`}
          alt="Both versions of the level"
        />
      )}
    </>
  );
}
