import { Square, Wrench } from 'lucide-react';
import { useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { proposalInWords, proposalRunInWords, SIZE_MEANS } from '../../../check/words/index.ts';
import type { Level } from '../../../schema/index.ts';
import type { Proposal } from '../../../solver/index.ts';
import { about, seconds } from '../../core/figures/index.ts';
import { Offer, Progress, Section, Trouble } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { FixState } from './fix-session.ts';
import { useSolverSession } from './index.ts';

/** The smallest changes that make the level completable, found on demand; each can be seen before it is taken. */
export function FixReport() {
  const { fixes } = useSolverSession();
  const state = useStore(fixes.store);
  const { phase, fixing, level, message, isOld } = state;
  const isSeeking = phase === 'seeking';
  const text = summaryOf(state);
  const end = useRef<HTMLDivElement>(null);
  // the command in the palette starts it while it may be out of sight
  useEffect(() => {
    if (isSeeking) end.current?.scrollIntoView({ block: 'nearest' });
  }, [isSeeking]);
  return (
    <Section
      title="Fix"
      aside={
        isSeeking ? (
          <Button hint="Stop seeking fixes" icon={<Square size={13} />} onClick={fixes.cancel}>
            Cancel
          </Button>
        ) : (
          <Button
            hint="Find the smallest change that makes the level completable"
            icon={<Wrench size={14} />}
            onClick={fixes.start}
          >
            {fixing === null ? 'Find fixes' : 'Find again'}
          </Button>
        )
      }
    >
      {(isSeeking || fixing !== null) && <Progress label="Seeking fixes" isRunning={isSeeking} />}
      {phase === 'failed' && <Trouble>Seeking fixes failed: {message}. Try again.</Trouble>}
      {fixing !== null && level !== null && fixing.proposals.length > 0 && (
        <ol className={isOld ? 'report__found report--old' : 'report__found'} aria-label="Proposals">
          {fixing.proposals.map((proposal) => (
            <ProposalOffer key={proposalInWords(level, proposal)} proposal={proposal} level={level} />
          ))}
        </ol>
      )}
      {text !== null && (
        <p className="part__note numbers" role="status">
          {text}
          {fixing !== null && !isOld && ` ${about(fixing.effort.runs)} simulations.`}
        </p>
      )}
      <div ref={end} />
      {fixing === null && phase === 'idle' && (
        <p className="part__note">The smallest changes that make the level completable, each shown before you take it.</p>
      )}
    </Section>
  );
}

/** What the search says about itself. */
function summaryOf({ phase, fixing, isOld }: FixState): string | null {
  if (fixing === null) return null;
  if (isOld) return 'The level has changed since: seek again.';
  if (fixing.completing !== null) return 'A run completes the level: there is nothing to fix.';
  if (fixing.proposals.length > 0) return 'Each is the smallest that was found of its kind.';
  if (phase === 'seeking') return 'None found yet.';
  return fixing.finished
    ? 'No single change of those that were tried is enough.'
    : 'None was found in the time set above. This does not prove that there is none.';
}

function ProposalOffer({ proposal, level }: { readonly proposal: Proposal; readonly level: Level }) {
  const { fixes } = useSolverSession();
  const { previewed, isOld } = useStore(fixes.store);
  const { change, size, run } = proposal;
  const moved = change === null ? 'the level stays as it is' : `${size.toFixed(1)} px`;
  return (
    <Offer
      text={proposalInWords(level, proposal)}
      figures={`${moved}, ${proposalRunInWords(level, proposal)}: ${seconds(run.time)}`}
      figuresTitle={SIZE_MEANS}
      isShown={previewed === proposal}
      onPreview={isOld ? null : () => fixes.preview(proposal)}
      onBack={fixes.back}
      onTake={fixes.take}
    />
  );
}
