! Answers `jointproof {asked} -- PROGRAM` with a routine {routine}:
!
!     gfortran -std=legacy this.f90 {file}
!
! (with jp_stubs.f90 where it calls XIT, STDB_ABQERR or GETVRM; `--out FOLDER` writes that and ABA_PARAM.INC, too).
!
{notes}
! What the interface has no place for is answered by `-`; a mistake in the use of the interface by `fault` and its name.
module driver_checks
    use, intrinsic :: iso_fortran_env, only: int64
    implicit none
    integer, parameter :: dp = kind(1.0d0), inputs = {inputs}, outputs = {outputs}
    ! Cells on both sides of every array, and what is in them.
    integer, parameter :: margin = 200, integer_guard = -987654321
    real(dp), parameter :: guard = -9.87654321e99_dp
    real(dp) :: x(inputs), y(outputs), jacobian(outputs, inputs)
    logical :: is_known(outputs, inputs), has_jacobian, is_refused, is_ordinary
    character(len=240) :: fault
    real(dp) :: of_stack
contains
    ! Overwrites what earlier calls have left on the stack, so that a variable that is never set does not hold what is right.
    recursive subroutine clear_stack()
        real(dp) :: rest(4000)
        rest = guard
        of_stack = rest(1 + drawn(0, 4000))
    end subroutine clear_stack

    ! The first mistake is kept.
    subroutine fail(what)
        character(len=*), intent(in) :: what
        if (fault == ' ') fault = what
    end subroutine fail

    ! Refuses a routine that writes before or behind an array.
    subroutine look_around(name, array, n)
        character(len=*), intent(in) :: name
        integer, intent(in) :: n
        real(dp), intent(in) :: array(1 - margin:n + margin)
        integer :: k
        do k = 1, margin
            if (array(1 - k) /= guard) call fail('writes before the array ' // name)
            if (array(n + k) /= guard) call fail('writes behind the array ' // name // ', which has ' // text(n) // ' numbers')
        end do
    end subroutine look_around

    subroutine look_around_integers(name, array, n)
        character(len=*), intent(in) :: name
        integer, intent(in) :: n, array(1 - margin:n + margin)
        integer :: k
        do k = 1, margin
            if (array(1 - k) /= integer_guard) call fail('writes before the array ' // name)
            if (array(n + k) /= integer_guard) then
                call fail('writes behind the array ' // name // ', which has ' // text(n) // ' numbers')
            end if
        end do
    end subroutine look_around_integers

    ! Refuses a routine that changes what it is only given.
    subroutine is_kept(name, n, found, given)
        character(len=*), intent(in) :: name
        integer, intent(in) :: n
        real(dp), intent(in) :: found(n), given(n)
        integer :: k
        do k = 1, n
            if (transfer(found(k), 0_int64) /= transfer(given(k), 0_int64)) then
                call fail('changes ' // name // ', which it is only given')
            end if
        end do
    end subroutine is_kept

    ! Refuses states that are no numbers, or so large that no sum or product of what was given accounts for them.
    subroutine look_at_states(name, states, size_of_inputs)
        character(len=*), intent(in) :: name
        real(dp), intent(in) :: states(:), size_of_inputs
        integer :: k
        do k = 1, size(states)
            if (.not. abs(states(k)) <= huge(1.0_dp)) call fail(name // '(' // text(k) // ') is not finite')
            if (size_of_inputs < 1e3_dp .and. abs(states(k)) > 1e3_dp * max(size_of_inputs, 1.0_dp)**2) then
                call fail(name // '(' // text(k) // ') is larger than anything that it was given: garbage')
            end if
        end do
    end subroutine look_at_states

    ! Whether numbers differ by more than rounding can explain; not where squares of numbers may leave the range of doubles.
    pure function differ(a, b, scale_of_both)
        real(dp), intent(in) :: a(:), b(:), scale_of_both
        logical :: differ
        differ = is_ordinary .and. .not. all(abs(a - b) <= 1e-6_dp * scale_of_both)
    end function differ

    ! A whole number from 0 to count - 1, the same at the same point.
    function drawn(stream, count)
        integer, intent(in) :: stream, count
        integer :: drawn, k
        integer(int64) :: bits
        bits = int(stream + 1, int64) * 7919_int64
        do k = 1, inputs
            bits = ieor(ieor(bits, transfer(x(k), 0_int64)), int(k, int64))
            bits = ieor(bits, ishft(bits, 13))
            bits = ieor(bits, ishft(bits, -7))
            bits = ieor(bits, ishft(bits, 17))
        end do
        drawn = int(modulo(ishft(bits, -11), int(count, int64)))
    end function drawn

    ! The largest power of two that is not above a number.
    pure function binade(number)
        real(dp), intent(in) :: number
        real(dp) :: binade
        binade = 0
        if (abs(number) > 0) binade = scale(1.0_dp, exponent(number) - 1)
    end function binade

    ! A start, of the given size where the end is 0, from which to the end is no rounding.
    function started(end, size_of_all, stream)
        real(dp), intent(in) :: end, size_of_all
        integer, intent(in) :: stream
        real(dp) :: started
        real(dp), parameter :: parts(5) = [0.25_dp, 0.5_dp, 0.75_dp, 1.25_dp, 0.375_dp]
        started = parts(1 + drawn(stream, 5)) * sign(binade(merge(end, size_of_all, abs(end) > 0)), end)
    end function started

    ! A power of two, so that the division by it does not round: large for large numbers, small for small ones.
    function power_of_two(size_of_all, stream)
        real(dp), intent(in) :: size_of_all
        integer, intent(in) :: stream
        real(dp) :: power_of_two
        integer :: power
        power = 1 + drawn(stream, 6)
        if (size_of_all < 1e-100_dp .or. size_of_all < 1e100_dp .and. drawn(stream + 1, 2) == 1) power = -power
        power_of_two = scale(1.0_dp, power)
    end function power_of_two

    pure function text(number)
        integer, intent(in) :: number
        character(len=:), allocatable :: text
        character(len=12) :: digits
        write (digits, '(i0)') number
        text = trim(digits)
    end function text
end module driver_checks

{ask}

program answer
    use driver_checks
    use driver_call, only: ask
    implicit none
    integer :: status, row, column
    do
        read (*, *, iostat=status) x
        if (status /= 0) exit
        is_known = .true.
        has_jacobian = .true.
        is_refused = .false.
        is_ordinary = all(abs(x) <= 1e100_dp .and. (abs(x) >= 1e-100_dp .or. .not. abs(x) > 0))
        fault = ' '
        call ask()
        if (fault /= ' ') then
            write (*, '(2a)') 'fault ', trim(fault)
        else if (is_refused) then
            write (*, '(a)') 'refuse'
        else
            write (*, '(*(es25.16e3))', advance='no') y
            do row = 1, merge(outputs, 0, has_jacobian)
                do column = 1, inputs
                    if (is_known(row, column)) then
                        write (*, '(es25.16e3)', advance='no') jacobian(row, column)
                    else
                        write (*, '(a)', advance='no') ' -'
                    end if
                end do
            end do
            write (*, '()')
        end if
        flush (6)
    end do
end program answer
