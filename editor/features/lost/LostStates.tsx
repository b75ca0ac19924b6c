import { Eye, EyeOff, Play, Square } from 'lucide-react';
import { useStore } from 'zustand';
import { TICK } from '../../../engine/index.ts';
import { ofLevel, useEditor, useLevel, useProof, useSession } from '../../core/context/index.ts';
import { about } from '../../core/figures/index.ts';
import { Progress, Section } from '../../core/panel/index.ts';
import { isWhole } from '../../core/proof/index.ts';
import { Button } from '../../core/ui/index.ts';
import { briefLossInWords, countLost, lostInWords, lostOf } from './index.ts';
import { useRunLoss } from './RunLoss.tsx';
import './lost.css';
import { type LostSession, watchLost } from './watch-lost.ts';

/** The examination of where an open level is already lost. */
export const lostSessionOf = ofLevel<LostSession>(({ session, desk }, level) => watchLost({ level, session, desk }));

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
