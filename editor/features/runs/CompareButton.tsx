import { GitCompare } from 'lucide-react';
import { Button } from '../../core/ui/index.ts';

interface CompareButtonProps {
  readonly name: string;
  /** Its number among the compared runs; null: it is not compared. */
  readonly compared: number | null;
  readonly onCompare: () => void;
  /** Whether it stands in a list in which keys do the same: then Tab passes it by. */
  readonly isInList?: boolean;
}

/** Puts a run or an attempt beside the shown run, or takes it away. */
export function CompareButton({ name, compared, onCompare, isInList = false }: CompareButtonProps) {
  return (
    <Button
      hint={compared === null ? `Compare ${name} with the shown run` : `Stop comparing ${name}, which is number ${compared}`}
      pressed={compared !== null}
      className="runs__compare"
      tabIndex={isInList ? -1 : undefined}
      icon={<GitCompare size={14} />}
      onClick={(event) => {
        // the row around it would show the run
        event.stopPropagation();
        onCompare();
      }}
    />
  );
}
