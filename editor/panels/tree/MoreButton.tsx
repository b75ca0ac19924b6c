import { EllipsisVertical } from 'lucide-react';
import { memo } from 'react';
import { showMenu } from './show-menu.ts';

/** Shows the menu of the row it is in. Who uses the keyboard has the menu key for it, so it is no stop of its own. */
export const MoreButton = memo(function MoreButton() {
  return (
    <button
      type="button"
      className="tree__more"
      tabIndex={-1}
      aria-hidden
      // the focus stays with the tree, which has the keys
      onMouseDown={(event) => event.preventDefault()}
      onDoubleClick={(event) => event.stopPropagation()}
      onClick={(event) => {
        event.stopPropagation();
        showMenu(event.currentTarget);
      }}
    >
      <EllipsisVertical size={14} />
    </button>
  );
});
