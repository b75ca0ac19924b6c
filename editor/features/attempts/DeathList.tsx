import { useId } from 'react';
import { useStore } from 'zustand';
import type { FailureCluster } from '../../../check/plays/index.ts';
import { causeInWords } from '../../core/attempts/index.ts';
import { useEditor, useLevel, useSession } from '../../core/context/index.ts';
import { percent, plural } from '../../core/figures/index.ts';
import { showLayer } from '../../core/session/index.ts';
import { shelfOf } from '../../core/shelf/index.ts';

/** Places that are listed. */
const MOST = 12;

/** Where and why players fail in the opened plays, the most frequent first; each place can be brought into view. */
export function DeathList() {
  const { session } = useEditor();
  const level = useLevel();
  const shelf = shelfOf(level);
  const statistics = useStore(shelf.store, (state) => state.statistics);
  const deaths = useStore(shelf.store, (state) => state.deaths);
  const isShown = useSession(({ layers }) => layers.deaths);
  const title = useId();
  if (statistics === null || statistics.attempts === 0) return null;
  const { attempts, share, clusters, causes } = statistics;
  const show = ({ x, y, plays }: FailureCluster) => {
    session.setState({ lookAt: { x, y } });
    const opened = shelf.store.getState().plays;
    shelf.select(plays.map((index) => opened[index].key));
  };
  return (
    <section className="deaths" aria-labelledby={title}>
      <div className="panel__head">
        <h3 id={title} className="panel__title">
          Failures
        </h3>
        {deaths !== null && (
          <label className="deaths__toggle">
            <input
              type="checkbox"
              checked={isShown}
              onChange={({ target: { checked } }) => showLayer(session, 'deaths', checked)}
            />
            on the canvas
          </label>
        )}
      </div>
      <p className="deaths__sum numbers">
        {plural(attempts, 'play')}: {percent(share)} complete the level
        {causes.length > 0 && `; most often she ${causeInWords(causes[0].cause)} (${percent(causes[0].share)} of failures)`}.
      </p>
      {clusters.length > 0 && (
        <ol className="deaths__list">
          {clusters.slice(0, MOST).map((cluster) => {
            const { cause, count, x, y } = cluster;
            const place = `${Math.round(x)}, ${Math.round(y)}`;
            return (
              <li key={`${cause.kind} ${cause.index} ${place}`}>
                <button type="button" className="row-button" title="Bring the place into view" onClick={() => show(cluster)}>
                  <b className="numbers">{count}×</b> she {causeInWords(cause)}{' '}
                  <span className="deaths__at numbers">at {place}</span>
                </button>
              </li>
            );
          })}
        </ol>
      )}
    </section>
  );
}
