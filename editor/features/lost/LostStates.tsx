import { Eye, EyeOff, Play, Square } from 'lucide-react';
import { useStore } from 'zustand';
import { TICK } from '../../../engine/index.ts';
import { momentPlace, type OnCanvas, reasonOf } from '../../canvas/index.ts';
import { useEditor, useLevel, useProof, useSession } from '../../core/context/index.ts';
import { about } from '../../core/figures/index.ts';
import { Progress, Section } from '../../core/panel/index.ts';
import { isWhole, type LiveProof } from '../../core/proof/index.ts';
import { Button } from '../../core/ui/index.ts';
import { type OnTimeline, toX } from '../../timeline/index.ts';
import { accuracyNameOf, type Loss } from '../../workers/index.ts';
import { briefLossInWords, countLost, lossInWords, lossKey, lostFromInWords, lostInWords, lostOf } from './index.ts';
import { lostSessionOf } from './watch-lost.ts';

/** Places that are listed. */
const MOST = 8;

/** Where the level is already lost although she lives on, while that is shown on the canvas: how far it is examined, and places. */
export function LostReport() {
  const editor = useEditor();
  const level = useLevel();
  const { commands, session } = editor;
  const lost = lostSessionOf(editor, level);
  const findings = useStore(lostOf(level));
  const isShown = useSession(({ layers }) => layers.lost);
  const { phase, losing, effort } = findings;
  const places = losing?.places.slice(0, MOST) ?? [];
  return (
    <Section
      title="Lost states"
      aside={
        <Button
          hint={isShown ? 'Hide the states that are already lost' : 'Shade states that are already lost on the canvas'}
          shortcut="L"
          icon={isShown ? <EyeOff size={14} /> : <Eye size={14} />}
          onClick={() => commands.run('view.layer-lost')}
        >
          {isShown ? 'Hide' : 'Show'}
        </Button>
      }
    >
      {!isShown ? (
        <p className="part__note">
          States from which the black hole can no longer be reached although she lives on, and since when a run that fails was
          lost.
        </p>
      ) : (
        <>
          {effort > 0 && (
            <Progress
              label="Examining lost states"
              isRunning={phase === 'examining'}
              share={Math.min(1, (losing?.ticks ?? 0) / effort)}
            />
          )}
          <p className={phase === 'failed' ? 'tone--bad' : 'part__note numbers'}>
            {lostInWords(findings)}
            {losing !== null && ` ${about(losing.ticks)} ticks.`}
          </p>
          {places.length > 0 && (
            <ol className="lost-places numbers" aria-label="Places where it is lost">
              {places.map(({ x, y, tick, known, alive }) => (
                <li key={`${x} ${y} ${tick}`}>
                  <button
                    type="button"
                    className="row-button"
                    title="Bring the place into view"
                    onClick={() => session.setState({ lookAt: { x, y } })}
                  >
                    <span
                      className={`shades__square lost-sign lost-sign--${known === 'proved' ? 'proved' : 'open'}`}
                      aria-hidden
                    />
                    {known === 'proved' ? 'proved' : 'no run found'} at {Math.round(x)}, {Math.round(y)}, alive for{' '}
                    {(alive * TICK).toFixed(1)} s
                  </button>
                </li>
              ))}
            </ol>
          )}
          <div className="part__row">
            {phase === 'examining' && (
              <Button hint="Stop, and keep what was found" icon={<Square size={13} />} look="outlined" onClick={lost.stop}>
                Stop
              </Button>
            )}
            {(phase === 'stopped' || (phase === 'done' && losing?.finished === false)) && (
              <Button hint="Search longer and with finer proofs" icon={<Play size={13} />} look="outlined" onClick={lost.goOn}>
                Go on
              </Button>
            )}
          </div>
        </>
      )}
    </Section>
  );
}

/** The legend of the shade of lost states, and since when the shown run was lost. Empty while they are not shown. */
export function LostLegend() {
  const { commands } = useEditor();
  const findings = useStore(lostOf(useLevel()));
  const isShown = useSession(({ layers, mode }) => layers.lost && mode === 'edit');
  const name = useProof(({ run }) => run.name);
  const time = useProof((proof) => (isWhole(proof) ? proof.run.time : null));
  const loss = useRunLoss();
  if (!isShown) return null;
  const since = loss === null || time === null ? null : briefLossInWords(loss, time);
  const { proved, notFound } = countLost(findings);
  const { phase, losing } = findings;
  return (
    <figure className="shades shades--left lost-legend" aria-label="Lost states">
      <figcaption className="lost-legend__head">
        <b>Lost although she lives on</b>
        {losing !== null && (
          <ul className="shades__list lost-legend__list numbers">
            <li>
              <span className="shades__square lost-sign lost-sign--proved" aria-hidden />
              proved lost: {proved}
            </li>
            <li>
              <span className="shades__square lost-sign lost-sign--open" aria-hidden />
              no run found: {notFound}
            </li>
          </ul>
        )}
        <p className={phase === 'needs a run' || phase === 'failed' ? 'lost-legend__note' : 'unseen'} role="status">
          {lostInWords(findings)}
        </p>
        <p className="lost-legend__run numbers" role="status">
          {since !== null && (
            <>
              <b>{name ?? 'Without a run'}</b>: {since}
            </>
          )}
        </p>
      </figcaption>
      <Button
        hint="Hide the lost states"
        shortcut="L"
        icon={<EyeOff size={14} />}
        onClick={() => commands.run('view.layer-lost')}
      />
    </figure>
  );
}

/** px that the words need to the right of the mark */
const ROOM = 190;

/** Since when the shown run is lost: a stripe until its end, dots where no run was found, strokes where it is proved. */
export function LossMark({ scale, width, end }: OnTimeline) {
  const loss = useRunLoss();
  const isShown = useSession(({ layers }) => layers.lost);
  const time = useProof((proof) => (isWhole(proof) ? proof.run.time : null));
  if (!isShown || loss === null || time === null) return null;
  const words = lostFromInWords(loss);
  const all = lossInWords(loss, time);
  const { lost, proved } = loss;
  const first = proved ?? lost;
  if (words === null || all === null || first === null) return null;
  const stripe = (from: number, to: number, look: string) => {
    const [left, right] = [Math.max(0, toX(scale, from)), Math.min(width, toX(scale, to))];
    return right > left && <div className={`timeline__loss timeline__loss--${look}`} style={{ left, width: right - left }} />;
  };
  const x = toX(scale, first.tick);
  const isIn = x >= 0 && x <= width;
  return (
    <div className="timeline__losses" role="img" aria-label={all} title={all}>
      {lost !== null && (proved === null || lost.tick < proved.tick) && stripe(lost.tick, proved?.tick ?? end, 'open')}
      {proved !== null && stripe(proved.tick, end, 'proved')}
      {isIn && (
        <div className={first.known === 'proved' ? 'timeline__lost' : 'timeline__lost timeline__lost--open'} style={{ left: x }}>
          <span className={x + ROOM > width ? 'timeline__since timeline__since--left' : 'timeline__since'}>{words}</span>
        </div>
      )}
    </div>
  );
}

const wayOf = ({ run }: LiveProof): LiveProof['run']['way'] => run.way;

/** Since when the shown run is lost, beside the place where it is lost. */
export function RunLossLabel({ canvas }: OnCanvas) {
  const { proof } = useLevel();
  const loss = useRunLoss();
  const isShown = useSession(({ layers, mode }) => layers.lost && mode === 'edit');
  const way = useProof(wayOf);
  const view = useStore(canvas, (state) => state.view);
  const words = loss === null ? null : lostFromInWords(loss);
  const at = loss?.proved ?? loss?.lost ?? null;
  if (words === null || at === null || !isShown) return null;
  const [x, y] = way.last;
  const place = momentPlace(words, at, { reason: reasonOf(proof.proof()), end: { x, y }, way }, view);
  return (
    <div
      className={at.known === 'proved' ? 'canvas__loss' : 'canvas__loss canvas__loss--open'}
      role="note"
      aria-label="Where the run is lost"
      style={{ transform: `translate(${place.x}px, ${place.y}px) translate(-50%, -50%)` }}
    >
      {words}
    </div>
  );
}

/** Since when the shown run is lost; null if it completes the level or nothing is known. */
function useRunLoss(): Loss | null {
  const losses = useStore(lostOf(useLevel()), (state) => state.losses);
  const key = useProof(({ run, terms }) => (run.outcome === 'completed' ? null : lossKey(run.holds, accuracyNameOf(terms))));
  return key === null ? null : (losses.get(key) ?? null);
}
