"""Work behind the caller's back."""

import threading

import pytest

from stylit_ref import InputError
from stylit_ref.views.work.behind import Behind


def refuse():
    raise InputError("no")


def test_the_caller_goes_on_meanwhile():
    may_end, done = threading.Event(), []
    with Behind() as behind:
        behind.do(lambda: (may_end.wait(10), done.append(1)))
        assert not done
        may_end.set()
    assert done == [1]


def test_one_thing_begins_when_the_one_before_is_done():
    done = []
    with Behind() as behind:
        for number in range(20):
            behind.do(done.append, number)
    assert done == list(range(20))


@pytest.mark.parametrize("then", [lambda behind: behind.wait(), lambda behind: behind.do(int)])
def test_what_went_wrong_is_raised_by_the_next_call(then):
    with Behind() as behind:
        behind.do(refuse)
        with pytest.raises(InputError, match="no"):
            then(behind)


def test_what_went_wrong_at_last_is_raised_at_the_end():
    with pytest.raises(InputError, match="no"), Behind() as behind:
        behind.do(refuse)
