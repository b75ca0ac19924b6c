import { Eye, EyeOff, Play, Square } from 'lucide-react';
import { useStore } from 'zustand';
import { TICK } from '../../../engine/index.ts';
import { useEditor, useLevel, useSession } from '../../core/context/index.ts';
import { about } from '../../core/figures/index.ts';
import { Progress, Section } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import { lostSessionOf } from './lost-session.ts';
import { lostOf } from './lost-store.ts';
import { lostInWords } from './lost-words.ts';

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
