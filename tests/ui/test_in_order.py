"""Long work as one function: each step gets the result of the one before, until it is given up."""

from armui.ui.background import in_order


class Work:
    """Two pieces of work, whose results come when they are handed over."""

    def __init__(self):
        self.wanted = True
        self.waiting = []
        self.got = []
        in_order(self._steps(), lambda: self.wanted)

    def _steps(self):
        self.got.append((yield self.waiting.append))
        self.got.append((yield self.waiting.append))

    def hand_over(self, result):
        self.waiting.pop()(result)


def test_the_second_step_begins_with_the_result_of_the_first_and_the_last_ends_it():
    work = Work()
    work.hand_over("one")
    assert work.got == ["one"]
    work.hand_over(None)
    assert work.got == ["one", None]
    assert not work.waiting


def test_work_that_is_given_up_ends_where_it_waits():
    work = Work()
    work.wanted = False
    work.hand_over("one")
    assert work.got == []
    assert not work.waiting
