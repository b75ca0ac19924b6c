import { useEditor } from '../context/index.ts';
import type { Fact } from '../figures/index.ts';

/** A list of labelled values; those with a moment lead there. */
export function Facts({ facts }: { readonly facts: readonly Fact[] }) {
  const { session } = useEditor();
  return (
    <dl className="facts numbers">
      {facts.map(({ label, value, tick, tone }) => (
        <div key={label} className="facts__row">
          <dt>{label}</dt>
          <dd className={tone === undefined ? undefined : `tone--${tone}`}>
            {tick === undefined ? (
              value
            ) : (
              <button
                type="button"
                className="facts__moment"
                title="Show this moment"
                onClick={() => session.setState({ tick, isPlayingBack: false })}
              >
                {value}
              </button>
            )}
          </dd>
        </div>
      ))}
    </dl>
  );
}
